(* Arctangents, and equalities that hold at one place and have equal derivatives. *)
From Coquelicot Require Export Coquelicot.
Require Export Mechproof.
Open Scope R_scope.

Lemma atan2_right (y x : R) : 0 < x -> atan2 y x = atan (y / x).
Proof. intro P. unfold atan2. destruct (Rlt_dec 0 x); [ reflexivity | lra ]. Qed.

Lemma atan2_above (y x : R) : x < 0 -> 0 <= y -> atan2 y x = atan (y / x) + PI.
Proof.
  intros N P. unfold atan2. destruct (Rlt_dec 0 x); [ lra | ].
  destruct (Rlt_dec x 0); [ | lra ]. destruct (Rle_dec 0 y); [ reflexivity | lra ].
Qed.

Lemma atan2_below (y x : R) : x < 0 -> y < 0 -> atan2 y x = atan (y / x) - PI.
Proof.
  intros N P. unfold atan2. destruct (Rlt_dec 0 x); [ lra | ].
  destruct (Rlt_dec x 0); [ | lra ]. destruct (Rle_dec 0 y); [ lra | reflexivity ].
Qed.

Lemma atan2_scaled (k y x : R) : 0 < k -> atan2 (k * y) (k * x) = atan2 y x.
Proof.
  intro P.
  assert (Q : x <> 0 -> k * y / (k * x) = y / x) by (intro; field; lra).
  unfold atan2.
  destruct (Rlt_dec 0 (k * x)), (Rlt_dec 0 x); try (exfalso; nra); [ now rewrite Q by lra | ].
  destruct (Rlt_dec (k * x) 0), (Rlt_dec x 0); try (exfalso; nra).
  - rewrite Q by lra. destruct (Rle_dec 0 (k * y)), (Rle_dec 0 y); try (exfalso; nra); reflexivity.
  - destruct (Rlt_dec 0 (k * y)), (Rlt_dec 0 y); try (exfalso; nra); try reflexivity.
    destruct (Rlt_dec (k * y) 0), (Rlt_dec y 0); try (exfalso; nra); reflexivity.
Qed.

Lemma double_arctangent_turned (t : R) :
  cos (2 * atan t) = (1 - t * t) / (1 + t * t) /\ sin (2 * atan t) = 2 * t / (1 + t * t).
Proof.
  assert (C : 0 < cos (atan t)) by (apply cos_gt_0; pose proof (atan_bound t); lra).
  assert (T : sin (atan t) = t * cos (atan t)).
  { pose proof (tan_atan t) as E. unfold tan in E. rewrite <- E at 2. field. lra. }
  pose proof (square_of_sine (atan t)) as S. rewrite T in S.
  assert (P : 0 < 1 + t * t) by nra.
  assert (Q : cos (atan t) * cos (atan t) = / (1 + t * t)).
  { apply (Rmult_eq_reg_l (1 + t * t)); [ | lra ]. rewrite Rinv_r by lra. lra. }
  replace (2 * atan t) with (atan t + atan t) by ring.
  rewrite cos_plus, sin_plus, T. split.
  - transitivity ((1 - t * t) * (cos (atan t) * cos (atan t))); [ ring | rewrite Q; reflexivity ].
  - transitivity (2 * t * (cos (atan t) * cos (atan t))); [ ring | rewrite Q; reflexivity ].
Qed.

Lemma cosine_with_arctangent (a t : R) :
  cos (a + 2 * atan t) = (cos a * (1 - t * t) - sin a * (2 * t)) / (1 + t * t).
Proof.
  destruct (double_arctangent_turned t) as [C S]. rewrite cos_plus, C, S. field. nra.
Qed.

Lemma sine_with_arctangent (a t : R) :
  sin (a + 2 * atan t) = (sin a * (1 - t * t) + cos a * (2 * t)) / (1 + t * t).
Proof.
  destruct (double_arctangent_turned t) as [C S]. rewrite sin_plus, C, S. field. nra.
Qed.

(* Angles of vectors of numbers, whose half planes are seen by enclosures. *)
Ltac turn_vectors :=
  let known := solve [ interval with (i_prec 60) | interval with (i_prec 120) | lra ] in
  repeat
    match goal with
    | |- context [atan2 ?y ?x] =>
        first
          [ rewrite (atan2_right y x) by known
          | rewrite (atan2_above y x) by known
          | rewrite (atan2_below y x) by known ]
    end.

(* Facts about numbers, integrals and angles of vectors among them. *)
Ltac enclose :=
  turn_vectors;
  solve
    [ interval with (i_prec 60)
    | interval with (i_prec 120)
    | integral
    | apply Rlt_not_eq; integral
    | apply Rgt_not_eq; unfold Rgt; integral
    | close ].

Ltac evaluate :=
  intros;
  repeat match goal with |- _ /\ _ => split end;
  first [ enclose | left; enclose | right; enclose ].

(* What is linear in a cosine is positive if it is so where the cosine is 1 and -1. *)
Lemma linear_positive (c a b p : R) :
  -1 <= c <= 1 -> 0 < a -> 0 < b -> p = (1 + c) / 2 * a + (1 - c) / 2 * b -> 0 < p.
Proof. intros C A B ->. nra. Qed.

Lemma equal_by_derivative (f g : R -> R) (a z : R) :
  (forall t, Rmin a z <= t <= Rmax a z -> is_derive (fun x => f x - g x) t 0) ->
  f a = g a -> f z = g z.
Proof.
  intros D E.
  assert (C : f z - g z = f a - g a); [ | lra ].
  destruct (Rtotal_order a z) as [L | [Q | G]].
  - symmetry. apply (eq_is_derive (fun x => f x - g x) a z); [ | exact L ].
    intros t B. apply D. rewrite Rmin_left, Rmax_right by lra. exact B.
  - now subst.
  - apply (eq_is_derive (fun x => f x - g x) z a); [ | exact G ].
    intros t B. apply D. rewrite Rmin_right, Rmax_left by lra. exact B.
Qed.

(* The arguments are the function, its derivative, and where it is not negative. *)
Lemma at_most_if_rising (f d : R -> R) (z less more : R) :
  0 <= z ->
  (forall t, 0 <= t <= z -> is_derive f t (d t)) ->
  (forall t, 0 <= t <= z -> 0 <= d t) ->
  f 0 = 0 -> f z = more - less -> less <= more.
Proof.
  intros P D N E F.
  destruct (MVT_gen f 0 z d) as (c & B & V).
  - intros t. rewrite Rmin_left, Rmax_right by lra. intro. apply D. lra.
  - intros t. rewrite Rmin_left, Rmax_right by lra. intro T. apply continuity_pt_filterlim.
    apply (ex_derive_continuous (V := R_NormedModule)). exists (d t). apply D, T.
  - rewrite Rmin_left, Rmax_right in B by lra.
    assert (0 <= d c * (z - 0)) by (apply Rmult_le_pos; [ apply N, B | lra ]). lra.
Qed.

(* The fundamental theorem, of what has a derivative everywhere. *)
Lemma derivative_of_integral (f : R -> R) (a b : R) :
  (forall v, ex_derive f v) -> is_derive (fun b => RInt f a b) b (f b).
Proof.
  intro D.
  assert (C : forall v, continuous f v).
  { intro v. apply (ex_derive_continuous (V := R_NormedModule)), D. }
  apply (is_derive_RInt f (fun b => RInt f a b) a b).
  - exists (mkposreal 1 Rlt_0_1). intros y _. apply (RInt_correct f a y).
    apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros. apply C.
  - apply C.
Qed.

Lemma empty_integral (f : R -> R) (a b : R) : b = a -> RInt f a b = 0.
Proof. intros ->. apply (RInt_point (V := R_CompleteNormedModule)). Qed.

Ltac within_bounds :=
  match goal with
  | B : Rmin ?a ?z <= ?t <= Rmax ?a ?z |- _ =>
      let P := fresh in let N := fresh in
      destruct (Rle_dec a z) as [P | N];
      [ rewrite Rmin_left, Rmax_right in B by lra | rewrite Rmin_right, Rmax_left in B by lra ];
      lra
  end.

Ltac zero := solve [ unfold Rdiv; ring | field; conditions ltac:(ring) ].

(* What `auto_derive` needs to be so, by what is known to differ from zero. *)
Ltac has_value :=
  repeat match goal with |- _ /\ _ => split end;
  match goal with
  | |- True => exact I
  | |- ex_derive ?f _ =>
      match goal with D : forall b, is_derive ?g b _ |- _ => unify f g; eexists; apply D end
  | |- _ <> _ => conditions ltac:(ring)
  | |- _ < _ => sign
  end.

Ltac has_values := repeat match goal with |- _ /\ _ => split end; try has_value.

(* Functions of what is zero. *)
Ltac at_zero :=
  unfold tan;
  repeat
    match goal with
    | |- context [sin ?u] =>
        replace (sin u) with 0 by (symmetry; replace u with 0 by zero; apply sin_0)
    | |- context [cos ?u] =>
        replace (cos u) with 1 by (symmetry; replace u with 0 by zero; apply cos_0)
    | |- context [atan ?u] =>
        replace (atan u) with 0 by (symmetry; replace u with 0 by zero; apply atan_0)
    end.

(* An arctangent of the opposite of what another one is of. *)
Ltac odd_arctangents :=
  repeat
    match goal with
    | |- context [atan ?u] =>
        match goal with
        | |- context [atan ?v] =>
            tryif constr_eq u v then fail
            else replace (atan u) with (- atan v) by
                (rewrite <- atan_opp; apply f_equal; zero)
        end
    end.

(* Angles that are equal to one are written as it is. *)
Ltac angles_as c :=
  let other u := tryif constr_eq u c then fail else idtac in
  let same := apply f_equal; solve [ unfold Rdiv; ring | field; conditions ltac:(ring) ] in
  repeat
    match goal with
    | |- context [sin ?u] => other u; replace (sin u) with (sin c) in * by same
    | |- context [cos ?u] => other u; replace (cos u) with (cos c) in * by same
    | _ : context [sin ?u] |- _ => other u; replace (sin u) with (sin c) in * by same
    | _ : context [cos ?u] |- _ => other u; replace (cos u) with (cos c) in * by same
    end.

(* One arctangent in place of another, where their arguments are equal. *)
Ltac join_arctangents whole :=
  match goal with
  | |- context [atan ?a] =>
      match goal with
      | |- context [atan ?b] =>
          first
            [ constr_eq a b; fail 1
            | replace (atan a) with (atan b) by (f_equal; solve [ whole ]) ]
      end
  end.

(* An equality as a whole, or that of all arguments of the functions on both sides. *)
Ltac by_depth whole :=
  let as_one := first [ reflexivity | solve [ whole ] ] in
  let one := first [ as_one | progress f_equal; as_one ] in
  let two := first [ as_one | progress f_equal; one ] in
  let three := first [ as_one | progress f_equal; two ] in
  first [ as_one | progress f_equal; three | join_arctangents whole; as_one ].
