(* Sums from 1 to a whole number, and what of them is linear. *)
From Coq Require Export Arith Lia.
Require Export Calculus.
Open Scope R_scope.

Fixpoint sum_to (n : nat) (f : nat -> R) : R :=
  match n with O => 0 | S m => sum_to m f + f (S m) end.

Definition kronecker (i j : nat) : R := if Nat.eq_dec i j then 1 else 0.

Lemma sum_alike (n : nat) (f g : nat -> R) :
  (forall i, (1 <= i <= n)%nat -> f i = g i) -> sum_to n f = sum_to n g.
Proof.
  induction n as [ | n I ]; intro E; simpl; [ reflexivity | ].
  rewrite I by (intros; apply E; lia). rewrite E by lia. reflexivity.
Qed.

Lemma sum_of_sums (n : nat) (f g : nat -> R) (a b : R) :
  sum_to n f = a -> sum_to n g = b -> sum_to n (fun i => f i + g i) = a + b.
Proof. intros <- <-. induction n; simpl; lra. Qed.

Lemma sum_of_multiples (n : nat) (f : nat -> R) (c a : R) :
  sum_to n f = a -> sum_to n (fun i => c * f i) = c * a.
Proof. intros <-. induction n as [ | n I ]; simpl; [ lra | rewrite I; lra ]. Qed.

Lemma sum_of_ones (n : nat) : sum_to n (fun _ => 1) = INR n.
Proof. induction n as [ | n I ]; [ reflexivity | simpl sum_to; rewrite S_INR; lra ]. Qed.

Lemma sum_of_none (n : nat) (f : nat -> R) :
  (forall i, (1 <= i <= n)%nat -> f i = 0) -> sum_to n f = 0.
Proof.
  induction n as [ | n I ]; intro E; simpl; [ reflexivity | ].
  rewrite I by (intros; apply E; lia). rewrite E by lia. lra.
Qed.

Lemma sum_not_negative (n : nat) (f : nat -> R) : (forall i, 0 <= f i) -> sum_to n f >= 0.
Proof. intro P. apply Rle_ge. induction n as [ | n I ]; simpl; [ lra | ]. specialize (P (S n)). lra. Qed.

Lemma sum_of_picked (n a : nat) (f : nat -> R) :
  (1 <= a <= n)%nat -> sum_to n (fun i => kronecker i a * f i) = f a.
Proof.
  induction n as [ | n I ]; intro B; [ lia | ]. simpl. unfold kronecker at 2.
  destruct (Nat.eq_dec (S n) a) as [ <- | N ].
  - rewrite sum_of_none; [ lra | ]. intros i D. unfold kronecker.
    destruct (Nat.eq_dec i (S n)); [ lia | lra ].
  - rewrite I by lia. lra.
Qed.

Lemma sum_swapped (n m : nat) (f : nat -> nat -> R) :
  sum_to n (fun i => sum_to m (fun j => f i j)) = sum_to m (fun j => sum_to n (fun i => f i j)).
Proof.
  induction n as [ | n I ]; simpl.
  - symmetry. now apply sum_of_none.
  - rewrite I. symmetry. now apply sum_of_sums.
Qed.

(* The same terms, where two indices are equal and where they are not. *)
Ltac same_terms :=
  unfold kronecker;
  repeat match goal with |- context [Nat.eq_dec ?a ?b] => destruct (Nat.eq_dec a b) end;
  subst; try lia; first [ unfold Rdiv; ring | field; conditions ltac:(ring) ].

(* The sum of each term, by the form of what it is to be. *)
Ltac add_up :=
  repeat
    first
      [ reflexivity
      | apply sum_of_sums
      | apply sum_of_multiples
      | apply sum_of_ones
      | rewrite sum_of_picked by lia; same_terms
      | apply sum_alike; intros; ring
      | rewrite sum_swapped; repeat (apply sum_alike; intros); ring ].

(* A fact in the form in which a lemma wants it. *)
Ltac given H :=
  first
    [ exact H
    | match type of H with
      | ?a = _ => match goal with |- ?b = _ => replace b with a by (by_depth ltac:(zero)) end
      | ?a <> _ => match goal with |- ?b <> _ => replace b with a by (by_depth ltac:(zero)) end
      | ?a >= _ => match goal with |- ?b >= _ => replace b with a by (by_depth ltac:(zero)) end
      | ?a > _ => match goal with |- ?b > _ => replace b with a by (by_depth ltac:(zero)) end
      end; exact H ].

(* Sums with few terms. *)
Ltac at_few := unfold kronecker; simpl; at_point.
