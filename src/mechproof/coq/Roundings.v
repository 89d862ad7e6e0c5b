(* Bounds of the roundings of straight-line programs in doubles.

   `analyse` runs a program in intervals, with its errors as linear forms of the roundings; `covers`
   halves a box until the bound holds. `error_bounded` says that they are right. Nothing overflows
   here: a rounding has the least exponent of doubles, and no largest. *)
From Coq Require Export Reals List ZArith Bool FloatOps Lia Lra.
From Flocq Require Import Core Relative.
From Interval Require Import Xreal Basic Sig Interval Float_full Primitive_ops.
Export ListNotations.
Open Scope R_scope.

Module F := PrimitiveFloat.
Module I := FloatIntervalFull F.

Definition rounded (x : R) : R := Generic_fmt.round radix2 (FLT_exp (-1074) 53) ZnearestE x.

Local Instance positive_precision : Prec_gt_0 53 := eq_refl.

Lemma rounded_off x : Rabs (rounded x - x) <= bpow radix2 (-53) * (Rabs x + bpow radix2 (-1000)).
Proof.
  destruct (error_N_FLT radix2 (-1074) 53 ltac:(reflexivity) (fun n => negb (Z.even n)) x)
    as (d & n & Hd & Hn & _ & E).
  unfold rounded. rewrite E.
  replace (x * (1 + d) + n - x) with (x * d + n) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_mult.
  assert (Rabs x * Rabs d <= Rabs x * bpow radix2 (-53)).
  { apply Rmult_le_compat_l; [apply Rabs_pos|]. apply Rle_trans with (1 := Hd). simpl bpow. lra. }
  assert (Rabs n <= bpow radix2 (-53) * bpow radix2 (-1000)).
  { apply Rle_trans with (1 := Hn). rewrite <- bpow_plus.
    apply Rle_trans with (1 * bpow radix2 (-1074)).
    - apply Rmult_le_compat_r; [apply bpow_ge_0|lra].
    - rewrite Rmult_1_l. apply bpow_le. lia. }
  lra.
Qed.

Lemma rounded_below x k : (-1000 <= k)%Z -> Rabs x <= bpow radix2 k ->
  Rabs (rounded x - x) <= bpow radix2 (k - 54).
Proof.
  intros K H. destruct (Req_dec x 0) as [->|Z].
  { unfold rounded. rewrite round_0 by auto with typeclass_instances.
    rewrite Rminus_0_r, Rabs_R0. apply bpow_ge_0. }
  destruct H as [H|H].
  - pose proof (error_le_half_ulp radix2 (FLT_exp (-1074) 53) (fun n => negb (Z.even n)) x) as L.
    apply Rle_trans with (1 := L).
    rewrite ulp_neq_0 by assumption. unfold cexp, FLT_exp.
    apply Rle_trans with (bpow radix2 (-1) * bpow radix2 (k - 53)).
    + simpl (bpow radix2 (-1)). apply Rmult_le_compat_l; [lra|]. apply bpow_le.
      generalize (mag_le_bpow radix2 x k Z H). lia.
    + rewrite <- bpow_plus. apply bpow_le. lia.
  - assert (G : generic_format radix2 (FLT_exp (-1074) 53) x).
    { apply generic_format_abs_inv. rewrite H. apply generic_format_bpow. unfold FLT_exp. lia. }
    unfold rounded. rewrite round_generic by auto with typeclass_instances.
    rewrite Rminus_eq_0, Rabs_R0. apply bpow_ge_0.
Qed.

Definition fraction := (Z * Z)%type.
Definition real (q : fraction) : R := IZR (fst q) / IZR (snd q).

(* Functions that are taken as rounded to nearest, too. *)
Inductive function := Sine | Cosine | Tangent | Arctangent | Exponential | Logarithm.

Definition call (f : function) : R -> R :=
  match f with
  | Sine => sin | Cosine => cos | Tangent => tan | Arctangent => atan | Exponential => exp
  | Logarithm => ln
  end.
Definition derivative (f : function) (x : R) : R :=
  match f with
  | Sine => cos x | Cosine => - sin x | Tangent => 1 / (cos x * cos x)
  | Arctangent => 1 / (1 + x * x) | Exponential => exp x | Logarithm => 1 / x
  end.
Definition has_derivative (f : function) (x : R) : Prop :=
  match f with Tangent => cos x <> 0 | Logarithm => 0 < x | _ => True end.

Lemma derivative_correct f x : has_derivative f x -> derivable_pt_lim (call f) x (derivative f x).
Proof.
  destruct f; simpl; intros H.
  - apply derivable_pt_lim_sin.
  - apply derivable_pt_lim_cos.
  - replace (1 / (cos x * cos x)) with ((cos x * cos x - - sin x * sin x) / Rsqr (cos x)).
    + apply (derivable_pt_lim_div sin cos); auto using derivable_pt_lim_sin, derivable_pt_lim_cos.
    + unfold Rsqr. generalize (sin2_cos2 x). unfold Rsqr. intros E.
      replace (cos x * cos x - - sin x * sin x) with (sin x * sin x + cos x * cos x) by ring.
      rewrite E. reflexivity.
  - replace (1 / (1 + x * x)) with (/ (1 + Rsqr x)) by (unfold Rsqr; field; nra).
    replace (Rsqr x) with (x ^ 2) by (unfold Rsqr; ring). apply derivable_pt_lim_atan.
  - apply derivable_pt_lim_exp.
  - unfold Rdiv. rewrite Rmult_1_l. now apply derivable_pt_lim_ln.
Qed.

Definition slope (f : function) (v w : R) : R :=
  if Req_EM_T v w then derivative f v else (call f v - call f w) / (v - w).

Lemma slope_correct f v w : call f v - call f w = slope f v w * (v - w).
Proof. unfold slope. destruct (Req_EM_T v w) as [->|N]; [ring|field; lra]. Qed.

(* By the theorem of the mean. *)
Lemma slope_between f v w :
  (forall x, Rmin v w <= x <= Rmax v w -> has_derivative f x) ->
  exists x, Rmin v w <= x <= Rmax v w /\ slope f v w = derivative f x.
Proof.
  intros H. unfold slope. destruct (Req_EM_T v w) as [->|N].
  { exists w. rewrite Rmin_left, Rmax_left by lra. split; [lra|reflexivity]. }
  assert (D : forall a b, a < b -> Rmin v w = a -> Rmax v w = b ->
    exists x, a <= x <= b /\ call f b - call f a = derivative f x * (b - a)).
  { intros a b L A B. destruct (MVT_cor2 (call f) (derivative f) a b L) as (x & E & I).
    - intros x I. apply derivative_correct, H. lra.
    - exists x. split; [lra|exact E]. }
  destruct (Rlt_le_dec v w) as [L|L].
  - destruct (D v w L) as (x & I & E); [apply Rmin_left; lra|apply Rmax_right; lra|].
    exists x. rewrite Rmin_left, Rmax_right by lra. split; [exact I|].
    replace (call f v - call f w) with (- (derivative f x * (w - v))) by lra. field. lra.
  - destruct (D w v ltac:(lra)) as (x & I & E); [apply Rmin_right; lra|apply Rmax_left; lra|].
    exists x. rewrite Rmin_right, Rmax_left by lra. split; [exact I|].
    rewrite E. field. lra.
Qed.

(* Operands are counted backwards from the last result. *)
Inductive operation :=
| Copied (a : nat) | Opposite (a : nat) | Sum (a b : nat) | Difference (a b : nat)
| Product (a b : nat) | Quotient (a b : nat) | Fused (a b c : nat) | Root (a : nat)
| Called (f : function) (a : nat).

(* A constant is a double that is meant, or one in place of another number. *)
Inductive step :=
| Exact (o : operation) | Rounded (o : operation) | Double (q : fraction)
| Constant (q r : fraction).

Local Notation "v .[ a ]" := (nth a v 0) (at level 2, a at level 200, format "v .[ a ]").
Local Notation "v .{ a }" := (nth a v I.nai) (at level 2, a at level 200, format "v .{ a }").

Definition value (o : operation) (v : list R) : R :=
  match o with
  | Copied a => v.[a] | Opposite a => - v.[a]
  | Sum a b => v.[a] + v.[b] | Difference a b => v.[a] - v.[b] | Product a b => v.[a] * v.[b]
  | Quotient a b => v.[a] / v.[b] | Fused a b c => v.[a] * v.[b] + v.[c] | Root a => sqrt v.[a]
  | Called f a => call f v.[a]
  end.

Definition compute (rounds : bool) (s : step) (v : list R) : R :=
  match s with
  | Exact o => value o v
  | Rounded o => if rounds then rounded (value o v) else value o v
  | Double q => real q
  | Constant q r => if rounds then real q else real r
  end.

Fixpoint run (rounds : bool) (steps : list step) (v : list R) : list R :=
  match steps with [] => v | s :: rest => run rounds rest (compute rounds s v :: v) end.

Definition result (rounds : bool) (steps : list step) (v : list R) : R :=
  (run rounds steps v).[0].

(* By how much the value moves if its operands move, exactly: from w to v. *)
Definition slopes (o : operation) (v w : list R) : list (nat * R) :=
  match o with
  | Copied a => [(a, 1)] | Opposite a => [(a, -1)]
  | Sum a b => [(a, 1); (b, 1)] | Difference a b => [(a, 1); (b, -1)]
  | Product a b => [(a, v.[b]); (b, w.[a])]
  | Quotient a b => [(a, 1 / v.[b]); (b, - (w.[a] / w.[b] / v.[b]))]
  | Fused a b c => [(a, v.[b]); (b, w.[a]); (c, 1)]
  | Root a => [(a, 1 / (sqrt v.[a] + sqrt w.[a]))]
  | Called f a => [(a, slope f v.[a] w.[a])]
  end.

Definition defined (o : operation) (v w : list R) : Prop :=
  match o with
  | Quotient a b => v.[b] <> 0 /\ w.[b] <> 0
  | Root a => 0 < v.[a] /\ 0 < w.[a]
  | Called f a => forall x, Rmin v.[a] w.[a] <= x <= Rmax v.[a] w.[a] -> has_derivative f x
  | _ => True
  end.

Fixpoint total (moved : list (nat * R)) (v w : list R) : R :=
  match moved with [] => 0 | (a, s) :: rest => s * (v.[a] - w.[a]) + total rest v w end.

Lemma slopes_correct o v w : defined o v w -> value o v - value o w = total (slopes o v w) v w.
Proof.
  destruct o; simpl; intros H; try ring.
  - field. tauto.
  - assert (0 < sqrt v.[a] + sqrt w.[a]).
    { apply Rplus_lt_le_0_compat; [apply sqrt_lt_R0; tauto|apply sqrt_pos]. }
    replace (v.[a] - w.[a]) with (sqrt v.[a] * sqrt v.[a] - sqrt w.[a] * sqrt w.[a]).
    2: rewrite !sqrt_sqrt by lra; ring.
    field. lra.
  - rewrite slope_correct. ring.
Qed.

(* The same of intervals. *)
Definition p : Z := 53%Z.
Definition one := I.fromZ p 1.

Definition call_in (f : function) (x : I.type) : I.type :=
  match f with
  | Sine => I.sin p x | Cosine => I.cos p x | Tangent => I.tan p x | Arctangent => I.atan p x
  | Exponential => I.exp p x | Logarithm => I.ln p x
  end.
Definition derivative_in (f : function) (x : I.type) : I.type :=
  match f with
  | Sine => I.cos p x | Cosine => I.neg (I.sin p x)
  | Tangent => I.div p one (I.mul p (I.cos p x) (I.cos p x))
  | Arctangent => I.div p one (I.add p one (I.mul p x x))
  | Exponential => I.exp p x | Logarithm => I.div p one x
  end.

Definition value_in (o : operation) (v : list I.type) : I.type :=
  match o with
  | Copied a => v.{a} | Opposite a => I.neg v.{a}
  | Sum a b => I.add p v.{a} v.{b} | Difference a b => I.sub p v.{a} v.{b}
  | Product a b => I.mul p v.{a} v.{b} | Quotient a b => I.div p v.{a} v.{b}
  | Fused a b c => I.add p (I.mul p v.{a} v.{b}) v.{c} | Root a => I.sqrt p v.{a}
  | Called f a => call_in f v.{a}
  end.

Definition slopes_in (o : operation) (v w : list I.type) : list (nat * I.type) :=
  match o with
  | Copied a => [(a, one)] | Opposite a => [(a, I.neg one)]
  | Sum a b => [(a, one); (b, one)] | Difference a b => [(a, one); (b, I.neg one)]
  | Product a b => [(a, v.{b}); (b, w.{a})]
  | Quotient a b => [(a, I.div p one v.{b}); (b, I.neg (I.div p (I.div p w.{a} w.{b}) v.{b}))]
  | Fused a b c => [(a, v.{b}); (b, w.{a}); (c, one)]
  | Root a => [(a, I.div p one (I.add p (I.sqrt p v.{a}) (I.sqrt p w.{a})))]
  | Called f a => [(a, derivative_in f (I.join v.{a} w.{a}))]
  end.

Definition is_not_zero (x : I.type) : bool :=
  match I.sign_strict x with Xlt | Xgt => true | _ => false end.
Definition is_positive (x : I.type) : bool :=
  match I.sign_strict x with Xgt => true | _ => false end.

Definition is_defined (o : operation) (v w : list I.type) : bool :=
  match o with
  | Quotient a b => is_not_zero v.{b} && is_not_zero w.{b}
  | Root a => is_positive v.{a} && is_positive w.{a}
  | Called Tangent a => is_not_zero (I.cos p (I.join v.{a} w.{a}))
  | Called Logarithm a => is_positive (I.join v.{a} w.{a})
  | _ => true
  end.

Definition has (x : I.type) (r : R) : Prop := contains (I.convert x) (Xreal r).
Definition have := Forall2 has.

Lemma is_not_zero_correct x r : is_not_zero x = true -> has x r -> r <> 0.
Proof.
  unfold is_not_zero. generalize (I.sign_strict_correct x).
  case (I.sign_strict x); try easy; intros H _ C; destruct (H _ C) as [_ S]; simpl in S; lra.
Qed.

Lemma is_positive_correct x r : is_positive x = true -> has x r -> 0 < r.
Proof.
  unfold is_positive. generalize (I.sign_strict_correct x).
  case (I.sign_strict x); try easy; intros H _ C; destruct (H _ C) as [_ S]; simpl in S; lra.
Qed.

Lemma has_nai r : has I.nai r.
Proof. unfold has. rewrite I.nai_correct. exact I. Qed.
Lemma has_at x r a : have x r -> has x.{a} r.[a].
Proof.
  intros H. revert a. induction H; intros [|a]; simpl; auto using has_nai.
Qed.
Lemma has_one : has one 1.
Proof. apply I.fromZ_correct. Qed.
Lemma has_add x y r s : has x r -> has y s -> has (I.add p x y) (r + s).
Proof. intros H K. exact (I.add_correct p x y _ _ H K). Qed.
Lemma has_sub x y r s : has x r -> has y s -> has (I.sub p x y) (r - s).
Proof. intros H K. exact (I.sub_correct p x y _ _ H K). Qed.
Lemma has_mul x y r s : has x r -> has y s -> has (I.mul p x y) (r * s).
Proof. intros H K. exact (I.mul_correct p x y _ _ H K). Qed.
Lemma has_neg x r : has x r -> has (I.neg x) (- r).
Proof. intros H. exact (I.neg_correct x _ H). Qed.
Lemma has_minus_one : has (I.neg one) (-1).
Proof. exact (has_neg one 1 has_one). Qed.
Lemma has_abs x r : has x r -> has (I.abs x) (Rabs r).
Proof. intros H. exact (I.abs_correct x _ H). Qed.
Lemma has_div x y r s : has x r -> has y s -> has (I.div p x y) (r / s).
Proof.
  intros H K. generalize (I.div_correct p x y _ _ H K). unfold has. simpl. unfold Xdiv'.
  case is_zero; [now destruct (I.convert (I.div p x y))|easy].
Qed.
Lemma has_sqrt x r : has x r -> has (I.sqrt p x) (sqrt r).
Proof. intros H. exact (I.sqrt_correct p x _ H). Qed.

Definition enclose (q : fraction) : I.type := I.div p (I.fromZ p (fst q)) (I.fromZ p (snd q)).
Lemma has_fraction q : has (enclose q) (real q).
Proof. apply has_div; apply I.fromZ_correct. Qed.

Definition power (k : Z) := I.power_int p (I.fromZ p 2) k.
Lemma has_power k : has (power k) (bpow radix2 k).
Proof.
  generalize (I.power_int_correct p k _ _ (I.fromZ_correct p 2)). unfold has, power.
  rewrite bpow_powerRZ. change (IZR radix2) with 2.
  unfold Xpower_int, Xbind, Xpower_int'. destruct k; simpl; auto.
  case is_zero_spec; [lra|auto].
Qed.

Definition is_at_most (x y : I.type) : bool :=
  match I.sign_large (I.sub p x y) with Xlt | Xeq => true | _ => false end.

Lemma is_at_most_correct x y r s : is_at_most x y = true -> has x r -> has y s -> r <= s.
Proof.
  unfold is_at_most. intros T H K. pose proof (has_sub _ _ _ _ H K) as M.
  generalize (I.sign_large_correct (I.sub p x y)). destruct I.sign_large; try easy; intros N;
    specialize (N _ M); [injection N|destruct N as [_ N]; simpl in N]; lra.
Qed.

(* Powers of two, of which each is a product of two that are listed. *)
Definition list_powers (f : nat -> Z) (n : nat) : list I.type :=
  map (fun i => power (f i)) (seq 0 n).
Definition small (i : nat) : Z := Z.of_nat i.
Definition large (i : nat) : Z := (64 * (Z.of_nat i - 18))%Z.
Definition small_powers := Eval vm_compute in list_powers small 64.
Definition large_powers := Eval vm_compute in list_powers large 35.
Definition find_power (k : Z) : I.type :=
  let (a, b) := Z.div_eucl k 64 in
  if (-18 <=? a)%Z
  then I.mul p large_powers.{Z.to_nat (a + 18)} small_powers.{Z.to_nat b} else I.nai.

Lemma small_listed : small_powers = list_powers small 64.
Proof. vm_compute. reflexivity. Qed.
Lemma large_listed : large_powers = list_powers large 35.
Proof. vm_compute. reflexivity. Qed.

Lemma has_listed f n i : has (list_powers f n).{i} (bpow radix2 (f i)).
Proof.
  unfold list_powers. destruct (Nat.lt_ge_cases i n) as [H|H].
  - rewrite nth_indep with (d' := power (f 0%nat)) by now rewrite map_length, seq_length.
    rewrite (map_nth (fun i => power (f i)) (seq 0 n) 0%nat), seq_nth by assumption.
    apply has_power.
  - rewrite nth_overflow by now rewrite map_length, seq_length. apply has_nai.
Qed.

Lemma has_found k : has (find_power k) (bpow radix2 k).
Proof.
  unfold find_power. generalize (Z_div_mod k 64 eq_refl).
  destruct (Z.div_eucl k 64) as [a b]. intros [-> B].
  destruct (-18 <=? a)%Z eqn:E; [|apply has_nai]. apply Z.leb_le in E.
  rewrite bpow_plus, small_listed, large_listed.
  replace (64 * a)%Z with (large (Z.to_nat (a + 18))) by (unfold large; lia).
  replace b with (small (Z.to_nat b)) at 2 by (unfold small; lia).
  auto using has_mul, has_listed.
Qed.

Definition between (b : I.type) : I.type := I.join (I.neg b) b.
Lemma has_between b r x : has b r -> Rabs x <= r -> has (between b) x.
Proof.
  intros H K. apply Rabs_le_inv in K.
  refine (contains_connected _ _ _ _ _ x K); apply I.join_correct; [left; apply has_neg|right];
    assumption.
Qed.

(* What a rounding is off by: by its size, and by the power of two above it. *)
Definition unit_roundoff := Eval vm_compute in power (-53).
Definition tiny := Eval vm_compute in power (-1000).
Definition rounding_in (x : I.type) : I.type :=
  let a := I.abs x in
  let k := snd (Z.frexp (I.upper a)) in
  let by_size := between (I.mul p unit_roundoff (I.add p a tiny)) in
  if (-1000 <=? k)%Z && is_at_most a (find_power k)
  then I.meet by_size (between (find_power (k - 54))) else by_size.

Lemma has_rounding x r : has x r -> has (rounding_in x) (rounded r - r).
Proof.
  intros H. unfold rounding_in. set (k := snd _).
  pose proof (has_abs _ _ H) as A.
  assert (S : has (between (I.mul p unit_roundoff (I.add p (I.abs x) tiny))) (rounded r - r)).
  { eapply has_between; [|apply rounded_off].
    exact (has_mul _ _ _ _ (has_power (-53)) (has_add _ _ _ _ A (has_power (-1000)))). }
  destruct ((-1000 <=? k)%Z && is_at_most (I.abs x) (find_power k)) eqn:E; [|assumption].
  apply Bool.andb_true_iff in E. destruct E as [E L]. apply Z.leb_le in E.
  apply I.meet_correct; auto.
  eapply has_between; [apply has_found|]. apply rounded_below; auto.
  eapply is_at_most_correct; eauto using has_found.
Qed.

Lemma has_sin x r : has x r -> has (I.sin p x) (sin r).
Proof. intros H. exact (I.sin_correct p x _ H). Qed.
Lemma has_cos x r : has x r -> has (I.cos p x) (cos r).
Proof. intros H. exact (I.cos_correct p x _ H). Qed.
Lemma has_call f x r : has x r -> has (call_in f x) (call f r).
Proof.
  intros H. destruct f; simpl; auto using has_sin, has_cos.
  - generalize (I.tan_correct p x _ H). unfold has, Xtan, Xbind, Xtan'.
    case is_zero; [now destruct (I.convert (I.tan p x))|easy].
  - exact (I.atan_correct p x _ H).
  - exact (I.exp_correct p x _ H).
  - generalize (I.ln_correct p x _ H). unfold has, Xln, Xbind, Xln'.
    case Xreal.is_positive; [easy|now destruct (I.convert (I.ln p x))].
Qed.
Lemma has_derivative_in f x r : has x r -> has (derivative_in f x) (derivative f r).
Proof.
  intros H. destruct f; cbn [derivative_in derivative];
    auto 9 using has_sin, has_cos, has_neg, has_div, has_mul, has_add, has_one.
  exact (has_call Exponential _ _ H).
Qed.
Lemma has_join x y r s t :
  has x r -> has y s -> Rmin r s <= t <= Rmax r s -> has (I.join x y) t.
Proof.
  intros H K B.
  refine (contains_connected _ _ _ _ _ t B); apply I.join_correct;
    unfold Rmin, Rmax; destruct (Rle_dec r s); auto.
Qed.

Lemma value_in_correct o x r : have x r -> has (value_in o x) (value o r).
Proof.
  intros H. destruct o; simpl;
    auto using has_at, has_neg, has_add, has_sub, has_mul, has_div, has_sqrt, has_call.
Qed.

Definition have_slopes := Forall2 (fun (x : nat * I.type) (r : nat * R) =>
  fst x = fst r /\ has (snd x) (snd r)).

Lemma slopes_in_correct o x y r s :
  have x r -> have y s -> defined o r s -> have_slopes (slopes_in o x y) (slopes o r s).
Proof.
  intros H K D.
  destruct o; cbn [slopes_in slopes];
    repeat (apply Forall2_cons; [split; [reflexivity|cbn [fst snd]]|]); try apply Forall2_nil;
    auto 9 using has_one, has_minus_one, has_at, has_neg, has_add, has_sub, has_mul, has_div,
      has_sqrt.
  destruct (slope_between f _ _ D) as (t & B & ->).
  apply has_derivative_in. eapply has_join; eauto using has_at.
Qed.

Lemma is_defined_correct o x y r s :
  have x r -> have y s -> is_defined o x y = true -> defined o r s.
Proof.
  intros H K. destruct o; simpl; auto; intros D;
    try (apply Bool.andb_true_iff in D;
      destruct D; split; eauto using is_not_zero_correct, is_positive_correct, has_at).
  intros t B. assert (J : has (I.join x.{a} y.{a}) t) by (eapply has_join; eauto using has_at).
  destruct f; simpl; auto; eauto using is_not_zero_correct, is_positive_correct, has_cos.
Qed.

(* Linear forms in the roundings. *)
Fixpoint dot (c d : list R) : R :=
  match c, d with a :: c', x :: d' => a * x + dot c' d' | _, _ => 0 end.
Fixpoint plus (c d : list R) : list R :=
  match c, d with a :: c', b :: d' => a + b :: plus c' d' | [], _ => d | _, [] => c end.
Definition times (s : R) := map (Rmult s).

Fixpoint dot_in (c d : list I.type) : I.type :=
  match c, d with
  | a :: c', x :: d' => I.add p (I.mul p a x) (dot_in c' d')
  | _, _ => I.zero
  end.
Fixpoint plus_in (c d : list I.type) : list I.type :=
  match c, d with a :: c', b :: d' => I.add p a b :: plus_in c' d' | [], _ => d | _, [] => c end.
Definition times_in (s : I.type) := map (I.mul p s).

Lemma has_zero : has I.zero 0.
Proof. unfold has. rewrite I.zero_correct. simpl. lra. Qed.
Lemma has_dot x y r s : have x r -> have y s -> has (dot_in x y) (dot r s).
Proof.
  intros H. revert y s. induction H; intros y' s' K; simpl; [apply has_zero|].
  destruct K; auto using has_zero, has_add, has_mul.
Qed.
Lemma have_plus x y r s : have x r -> have y s -> have (plus_in x y) (plus r s).
Proof.
  intros H. revert y s. induction H; intros y' s' K; simpl; auto.
  destruct K; constructor; auto using has_add. apply IHForall2. assumption.
Qed.
Lemma have_times x y r s : has x r -> have y s -> have (times_in x y) (times r s).
Proof. intros H K. induction K; constructor; auto using has_mul. Qed.

Lemma dot_plus c d e : dot (plus c d) e = dot c e + dot d e.
Proof.
  revert d e. induction c as [|a c IH]; intros [|b d] [|x e]; simpl; try ring.
  rewrite IH. ring.
Qed.
Lemma dot_times s c d : dot (times s c) d = s * dot c d.
Proof. revert d. induction c as [|a c IH]; intros [|x d]; simpl; try ring. rewrite IH. ring. Qed.
Lemma dot_longer c d x : (length c <= length d)%nat -> dot c (d ++ [x]) = dot c d.
Proof.
  revert d. induction c as [|a c IH]; intros [|y d]; simpl; intros H; try easy; try lia.
  rewrite IH by lia. reflexivity.
Qed.
Lemma length_plus c d n :
  (length c <= n)%nat -> (length d <= n)%nat -> (length (plus c d) <= n)%nat.
Proof.
  revert d n. induction c as [|a c IH]; intros [|b d] n; simpl; auto.
  intros H K. destruct n; [lia|]. apply le_n_S, IH; lia.
Qed.

(* A unit of the next rounding. *)
Definition unit (n : nat) : list R := repeat 0 n ++ [1].
Definition unit_in (n : nat) : list I.type := repeat I.zero n ++ [one].
Lemma have_unit n : have (unit_in n) (unit n).
Proof.
  unfold unit, unit_in.
  induction n; simpl; apply Forall2_cons; auto using has_one, has_zero, Forall2_nil.
Qed.
Lemma dot_unit d x : dot (unit (length d)) (d ++ [x]) = x.
Proof. unfold unit. induction d; simpl; [ring|rewrite IHd; ring]. Qed.
Lemma length_unit n : length (unit n) = S n.
Proof. unfold unit. rewrite app_length, repeat_length. simpl. lia. Qed.

Definition combine (forms : list (list R)) (moved : list (nat * R)) : list R :=
  fold_right (fun s c => plus (times (snd s) (nth (fst s) forms [])) c) [] moved.
Definition combine_in (forms : list (list I.type)) (moved : list (nat * I.type)) :=
  fold_right (fun s c => plus_in (times_in (snd s) (nth (fst s) forms [])) c) [] moved.

Lemma have_combine x r s t :
  Forall2 have x r -> have_slopes s t -> have (combine_in x s) (combine r t).
Proof.
  intros H K. induction K as [|[a i] [b u] s t [E V] K IH]; simpl in *; [constructor|].
  apply have_plus; auto. apply have_times; auto. subst b.
  clear - H. revert a. induction H; intros [|a]; simpl; auto; constructor.
Qed.

Definition errors_are (forms : list (list R)) (d v w : list R) : Prop :=
  forall a, v.[a] - w.[a] = dot (nth a forms []) d.
Definition are_short (forms : list (list R)) (n : nat) : Prop :=
  forall a, (length (nth a forms []) <= n)%nat.

Lemma dot_combine forms d v w moved :
  errors_are forms d v w -> dot (combine forms moved) d = total moved v w.
Proof.
  intros H. induction moved as [|[a s] moved IH]; simpl.
  - destruct d; reflexivity.
  - rewrite dot_plus, dot_times, IH, <- H. reflexivity.
Qed.
Lemma length_combine forms n moved :
  are_short forms n -> (length (combine forms moved) <= n)%nat.
Proof.
  intros H. induction moved as [|[a s] moved IH]; simpl; [lia|].
  apply length_plus; auto. unfold times. rewrite map_length. apply H.
Qed.

(* The analysis: what is exact, what is computed, linear forms, and the roundings. *)
Record state := State {
  exact_in : list I.type; computed_in : list I.type;
  forms_in : list (list I.type); roundings_in : list I.type }.

Definition after (o : operation) (is_rounded : bool) (s : state) : option state :=
  let v := computed_in s in
  let w := exact_in s in
  if is_defined o v w then
    let moved := combine_in (forms_in s) (slopes_in o v w) in
    let d := roundings_in s in
    let '(form, d') :=
      if is_rounded
      then (plus_in moved (unit_in (length d)),
            d ++ [rounding_in (value_in o v)])
      else (moved, d) in
    let e := value_in o w in
    Some (State (e :: w) (I.add p e (dot_in form d') :: v) (form :: forms_in s) d')
  else None.

Definition less (q r : fraction) : fraction :=
  (fst q * snd r - fst r * snd q, snd q * snd r)%Z.

(* What of a constant is the same in every box: double, number, and the difference. *)
Definition prepare (s : step) : step * list I.type :=
  (s, match s with
      | Double q => [enclose q]
      | Constant q r => [enclose q; enclose r; enclose (less q r)]
      | _ => []
      end).

Definition after_constant (q r : fraction) (known : list I.type) (s : state) : option state :=
  if (snd q =? 0)%Z || (snd r =? 0)%Z then None else
  Some (State (known.{1} :: exact_in s) (known.{0} :: computed_in s)
    (unit_in (length (roundings_in s)) :: forms_in s) (roundings_in s ++ [known.{2}])).

Definition after_double (known : list I.type) (s : state) : state :=
  State (known.{0} :: exact_in s) (known.{0} :: computed_in s) ([] :: forms_in s) (roundings_in s).

Fixpoint analyse (steps : list (step * list I.type)) (s : state) : option state :=
  match steps with
  | [] => Some s
  | (next, known) :: rest =>
    match (match next with
      | Exact o => after o false s
      | Rounded o => after o true s
      | Double _ => Some (after_double known s)
      | Constant q r => after_constant q r known s
      end) with
    | Some s' => analyse rest s'
    | None => None
    end
  end.

Definition describes (s : state) (v w : list R) : Prop :=
  have (exact_in s) w /\ have (computed_in s) v /\
  exists forms d, Forall2 have (forms_in s) forms /\ have (roundings_in s) d /\
  errors_are forms d v w /\ are_short forms (length d).

Lemma length_have x r : have x r -> length x = length r.
Proof. intros H. induction H; simpl; auto. Qed.

Lemma after_correct o is_rounded s s' v w :
  describes s v w -> after o is_rounded s = Some s' ->
  describes s' ((if is_rounded then rounded (value o v) else value o v) :: v) (value o w :: w).
Proof.
  intros (W & V & forms & d & F & D & E & S). unfold after.
  destruct (is_defined o _ _) eqn:K; [|easy].
  apply (is_defined_correct _ _ _ _ _ V W) in K.
  pose proof (slopes_in_correct o _ _ _ _ V W K) as M. apply slopes_correct in K.
  pose proof (have_combine _ _ _ _ F M) as C.
  pose proof (dot_combine forms d v w (slopes o v w) E) as T.
  pose proof (length_combine forms (length d) (slopes o v w) S) as L.
  assert (N : has (value_in o (exact_in s)) (value o w)) by now apply value_in_correct.
  destruct is_rounded; intros H; injection H as <-.
  - set (x := rounded (value o v) - value o v).
    assert (P : have (roundings_in s ++ [rounding_in (value_in o (computed_in s))])
                  (d ++ [x])).
    { apply Forall2_app; auto. apply Forall2_cons, Forall2_nil.
      now apply has_rounding, value_in_correct. }
    set (form := plus (combine forms (slopes o v w)) (unit (length d))).
    assert (Q : have (plus_in (combine_in (forms_in s) (slopes_in o (computed_in s) (exact_in s)))
                  (unit_in (length (roundings_in s)))) form).
    { apply have_plus; auto. rewrite (length_have _ _ D). apply have_unit. }
    assert (R : rounded (value o v) - value o w = dot form (d ++ [x])).
    { unfold form. rewrite dot_plus, dot_longer, dot_unit by assumption.
      rewrite T, <- K. unfold x. ring. }
    split; [|split]; simpl.
    + constructor; auto.
    + constructor; auto.
      replace (rounded (value o v)) with (value o w + dot form (d ++ [x])) by (rewrite <- R; ring).
      apply has_add; auto. now apply has_dot.
    + exists (form :: forms), (d ++ [x]). repeat split; auto.
      * intros [|a]; simpl; auto. rewrite dot_longer; auto.
      * intros [|a]; simpl; rewrite app_length; simpl.
        -- apply length_plus; [lia|rewrite length_unit; lia].
        -- specialize (S a). lia.
  - set (form := combine forms (slopes o v w)).
    assert (R : value o v - value o w = dot form d) by (unfold form; rewrite T; auto).
    split; [|split]; simpl.
    + constructor; auto.
    + constructor; auto.
      replace (value o v) with (value o w + dot form d) by (rewrite <- R; ring).
      apply has_add; auto. now apply has_dot.
    + exists (form :: forms), d. repeat split; auto.
      * intros [|a]; simpl; auto.
      * intros [|a]; simpl; auto.
Qed.

Lemma real_less q r : snd q <> 0%Z -> snd r <> 0%Z -> real (less q r) = real q - real r.
Proof.
  intros H K. unfold real, less. simpl. rewrite minus_IZR, !mult_IZR. field.
  split; now apply not_0_IZR.
Qed.

Lemma after_constant_correct q r s s' v w :
  describes s v w -> after_constant q r (snd (prepare (Constant q r))) s = Some s' ->
  describes s' (real q :: v) (real r :: w).
Proof.
  intros (W & V & forms & d & F & D & E & S). unfold after_constant.
  destruct ((snd q =? 0)%Z || (snd r =? 0)%Z) eqn:Z; [discriminate|].
  apply orb_false_iff in Z. destruct Z as [Q R]. apply Z.eqb_neq in Q, R.
  intros H. injection H as <-. split; [|split]; simpl.
  - apply Forall2_cons; auto using has_fraction.
  - apply Forall2_cons; auto using has_fraction.
  - exists (unit (length d) :: forms), (d ++ [real (less q r)]). repeat split.
    + apply Forall2_cons; auto. rewrite (length_have _ _ D). apply have_unit.
    + apply Forall2_app; auto. apply Forall2_cons, Forall2_nil. apply has_fraction.
    + intros [|n]; simpl.
      * now rewrite dot_unit, real_less.
      * rewrite dot_longer; auto.
    + intros [|n]; simpl; rewrite app_length; simpl.
      * rewrite length_unit. lia.
      * specialize (S n). lia.
Qed.

Lemma after_double_correct q s v w :
  describes s v w -> describes (after_double [enclose q] s) (real q :: v) (real q :: w).
Proof.
  intros (W & V & forms & d & F & D & E & S).
  split; [|split]; simpl; try (apply Forall2_cons; auto using has_fraction).
  exists ([] :: forms), d. repeat split; auto.
  - apply Forall2_cons; auto. apply Forall2_nil.
  - intros [|n]; simpl; [ring|auto].
  - intros [|n]; simpl; [lia|auto].
Qed.

Lemma analyse_correct steps s s' v w :
  describes s v w -> analyse (map prepare steps) s = Some s' ->
  describes s' (run true steps v) (run false steps w).
Proof.
  revert s v w. induction steps as [|next steps IH]; simpl; intros s v w H.
  - intros K. injection K as <-. assumption.
  - destruct next as [o|o|q|q r]; simpl.
    + destruct (after o false s) as [t|] eqn:K; [|easy].
      exact (IH _ _ _ (after_correct o false _ _ _ _ H K)).
    + destruct (after o true s) as [t|] eqn:K; [|easy].
      exact (IH _ _ _ (after_correct o true _ _ _ _ H K)).
    + exact (IH _ _ _ (after_double_correct _ _ _ _ H)).
    + destruct (after_constant q r _ s) as [t|] eqn:K; [|easy].
      exact (IH _ _ _ (after_constant_correct _ _ _ _ _ _ H K)).
Qed.

(* Boxes. *)
Definition start (box : list I.type) : state := State box box [] [].

Lemma start_correct box x : have box x -> describes (start box) x x.
Proof.
  intros H. split; [|split]; auto. exists [], []. repeat split; try constructor.
  - intros a. destruct a; simpl; ring.
  - intros a. destruct a; simpl; lia.
Qed.

Definition is_within (relative : bool) (b : I.type) (steps : list (step * list I.type))
    (box : list I.type) :=
  match analyse steps (start box) with
  | Some s =>
    let e := dot_in (hd [] (forms_in s)) (roundings_in s) in
    let bar := if relative then I.mul p b (I.abs (exact_in s).{0}) else b in
    is_at_most (I.abs e) bar
  | None => false
  end.

Definition error (steps : list step) (v : list R) : R := result true steps v - result false steps v.
Definition bar (relative : bool) (b : R) (steps : list step) (v : list R) : R :=
  if relative then b * Rabs (result false steps v) else b.

Lemma is_within_correct relative b b' steps box x :
  has b b' -> have box x -> is_within relative b (map prepare steps) box = true ->
  Rabs (error steps x) <= bar relative b' steps x.
Proof.
  intros B H. unfold is_within, error, bar, result.
  destruct (analyse (map prepare steps) (start box)) as [s|] eqn:A; [|easy].
  destruct (analyse_correct _ _ _ _ _ (start_correct _ _ H) A) as (W & V & f & d & F & D & E & _).
  rewrite (E 0%nat). generalize (has_at _ _ 0 W). intros K.
  assert (L : has (dot_in (hd [] (forms_in s)) (roundings_in s)) (dot (nth 0 f []) d)).
  { apply has_dot; auto. destruct F; simpl; auto. constructor. }
  set (w := (run false steps x).[0]) in *.
  set (e := dot (nth 0 f []) d) in *.
  set (t := if relative then I.mul p b (I.abs (exact_in s).{0}) else b).
  assert (T : has t (if relative then b' * Rabs w else b')).
  { unfold t. destruct relative; auto using has_mul, has_abs. }
  intros M. eapply is_at_most_correct in M; eauto using has_abs.
Qed.

Fixpoint put (a : nat) (x : I.type) (box : list I.type) : list I.type :=
  match box, a with
  | [], _ => []
  | _ :: rest, O => x :: rest
  | y :: rest, S b => y :: put b x rest
  end.

(* The inputs in `turn` are halved in turn until the test holds. *)
Fixpoint covers (fuel : nat) (test : list I.type -> bool) (turn : list nat) (box : list I.type) :=
  if test box then true else
  match fuel, turn with
  | S n, a :: rest =>
    let (l, r) := I.bisect box.{a} in
    let later := rest ++ [a] in
    if covers n test later (put a l box) then covers n test later (put a r box) else false
  | _, _ => false
  end.

Lemma have_put a x r box v : have box v -> has x r -> r = v.[a] -> have (put a x box) v.
Proof.
  intros H. revert a. induction H; intros [|a]; simpl; intros K E; constructor; auto.
  - now rewrite <- E.
  - apply IHForall2; auto.
Qed.

Lemma covers_correct (P : list R -> Prop) fuel test :
  (forall box v, have box v -> test box = true -> P v) ->
  forall turn box v, have box v -> covers fuel test turn box = true -> P v.
Proof.
  intros C. induction fuel as [|n IH]; simpl; intros turn box v H.
  - destruct (test box) eqn:T; [intros _; eauto|easy].
  - destruct (test box) eqn:T; [intros _; eauto|].
    destruct turn as [|a rest]; [easy|].
    pose proof (I.bisect_correct _ _ (has_at _ _ a H)) as B.
    destruct (I.bisect box.{a}) as [l r]. simpl in B.
    destruct (covers n test _ (put a l box)) eqn:K; [|easy].
    intros L. destruct B as [B|B]; [refine (IH _ _ _ _ K)|refine (IH _ _ _ _ L)];
      eapply have_put; eauto.
Qed.

Definition span (q : fraction * fraction) : I.type := I.join (enclose (fst q)) (enclose (snd q)).
Definition lies (q : fraction * fraction) (x : R) : Prop := real (fst q) <= x <= real (snd q).

Lemma has_span q x : lies q x -> has (span q) x.
Proof.
  intros H. refine (contains_connected _ _ _ _ _ x H);
    apply I.join_correct; [left|right]; apply has_fraction.
Qed.

Lemma result_next rounds s rest v x y :
  compute rounds s v = x -> result rounds rest (x :: v) = y -> result rounds (s :: rest) v = y.
Proof. intros <-. auto. Qed.

(* What scripts apply: no input of the box has an error above the bound. *)
Theorem error_bounded relative b steps ranges turn fuel v x y :
  result true steps v = x -> result false steps v = y -> Forall2 lies ranges v ->
  covers fuel (is_within relative (enclose b) (map prepare steps)) turn (map span ranges) = true ->
  Rabs (x - y) <= (if relative then real b * Rabs y else real b).
Proof.
  intros <- <- H.
  apply (covers_correct (fun v => Rabs (error steps v) <= bar relative (real b) steps v)).
  - intros box x K. apply is_within_correct; auto using has_fraction.
  - induction H; constructor; auto using has_span.
Qed.

(* The results of a program, one after another, as a statement names them. *)
Ltac follow names :=
  lazymatch names with
  | (?rest, ?x) => follow rest; follow x
  | ?x => refine (result_next _ _ _ _ x _ _ _); [reflexivity|]
  end.
