(* What the proofs of all rows share: lemmas and tactics, and nothing that is assumed. *)
From Coq Require Export Reals Lra Psatz.
From Interval Require Export Tactic.
Open Scope R_scope.

(* The angle of the vector (x, y), in (-PI, PI]. *)
Definition atan2 (y x : R) : R :=
  if Rlt_dec 0 x then atan (y / x)
  else if Rlt_dec x 0 then (if Rle_dec 0 y then atan (y / x) + PI else atan (y / x) - PI)
  else if Rlt_dec 0 y then PI / 2
  else if Rlt_dec y 0 then - (PI / 2)
  else 0.

Lemma square_of_sine (x : R) : sin x * sin x = 1 - cos x * cos x.
Proof. pose proof (sin2_cos2 x) as H. unfold Rsqr in H. lra. Qed.

Lemma less_by (a b d : R) : b - a = d -> 0 < d -> a < b.
Proof. lra. Qed.

Lemma at_most_by (a b d : R) : b - a = d -> 0 <= d -> a <= b.
Proof. lra. Qed.

Lemma root_of_product (a m b : R) : 0 <= m -> 0 <= b -> a = m * m * b -> sqrt a = m * sqrt b.
Proof. intros P N E. rewrite E, sqrt_mult_alt by nra. now rewrite sqrt_square. Qed.

Lemma root_of_two (a m b c : R) :
  0 <= m -> 0 <= b -> 0 <= c -> a = m * m * (b * c) -> sqrt a = m * (sqrt b * sqrt c).
Proof.
  intros P N O E. rewrite <- sqrt_mult_alt by exact N.
  apply root_of_product; [ exact P | apply Rmult_le_pos; assumption | exact E ].
Qed.

Lemma positive_unless_zero (x : R) : x >= 0 -> x <> 0 -> 0 < x.
Proof. lra. Qed.

Lemma within_size (x : R) : - Rabs x <= x <= Rabs x.
Proof. pose proof (Rle_abs x) as A. pose proof (Rle_abs (- x)) as B. rewrite Rabs_Ropp in B. lra. Qed.

Lemma root_over (a n d : R) : 0 < d -> 0 <= n -> a = n / (d * d) -> sqrt a = sqrt n / d.
Proof.
  intros P N ->. rewrite sqrt_div_alt by nra. now rewrite sqrt_square by lra.
Qed.

Lemma sine_of_right_angle : sin (1 / 2 * PI) = 1.
Proof. replace (1 / 2 * PI) with (PI / 2) by field. apply sin_PI2. Qed.

Lemma cosine_of_right_angle : cos (1 / 2 * PI) = 0.
Proof. replace (1 / 2 * PI) with (PI / 2) by field. apply cos_PI2. Qed.

Lemma double_arctangent (t : R) : - (1) < t -> t < 1 -> 2 * atan t = atan (2 * t / (1 - t * t)).
Proof.
  intros L U.
  pose proof (atan_increasing _ _ U) as A. pose proof (atan_increasing _ _ L) as B.
  rewrite atan_opp in B. rewrite atan_1 in A, B.
  pose proof PI_RGT_0 as P.
  rewrite <- (atan_tan (2 * atan t)) by lra.
  f_equal. rewrite tan_2a.
  - now rewrite tan_atan.
  - apply Rgt_not_eq, cos_gt_0; lra.
  - apply Rgt_not_eq, cos_gt_0; lra.
  - rewrite tan_atan. nra.
Qed.

(* What is made of parts whose signs are known has its own sign. *)
Ltac structure :=
  first
    [ assumption
    | match goal with
      | H : ?a >= 0 |- 0 <= ?a => exact (Rge_le _ _ H)
      | H : ?a >= 0, N : ?a <> 0 |- 0 < ?a => exact (positive_unless_zero _ H N)
      | |- 0 <= _ ^ 2 => apply pow2_ge_0
      | |- 0 <= sqrt _ => apply sqrt_pos
      | |- 0 <= Rabs _ => apply Rabs_pos
      | |- 0 < exp _ => apply exp_pos
      | |- 0 < sqrt _ => apply sqrt_lt_R0; structure
      | |- 0 < _ ^ _ => apply pow_lt; structure
      | |- 0 <= _ ^ _ => apply pow_le; structure
      | |- 0 < _ * _ => apply Rmult_lt_0_compat; structure
      | |- 0 <= _ * _ => apply Rmult_le_pos; structure
      | |- 0 < _ / _ => apply Rdiv_lt_0_compat; structure
      | |- 0 <= _ / _ => apply Rle_mult_inv_pos; structure
      | |- 0 < / _ => apply Rinv_0_lt_compat; structure
      | |- 0 <= / _ => apply Rlt_le, Rinv_0_lt_compat; structure
      | |- 0 <= _ + _ => apply Rplus_le_le_0_compat; structure
      | |- 0 < _ + _ => apply Rplus_lt_le_0_compat; structure
      | |- 0 < _ + _ => apply Rplus_le_lt_0_compat; structure
      end
    | lra ].

(* A number differs from zero if another form of it does, which `same` shows, or by its size. *)
Ltac differs same :=
  solve
    [ assumption
    | lra
    | match goal with
      | H : ?D <> 0 |- ?E <> 0 =>
          let F := fresh in intro F; apply H; first [ lra | rewrite <- F; same ]
      end
    | match goal with
      | H : ?D <> 0 |- ?E <> 0 =>
          let F := fresh in
          intro F; apply H;
          first
            [ transitivity (- E); [ same | rewrite F; ring ]
            | transitivity (2 * E); [ same | rewrite F; ring ]
            | transitivity (- 2 * E); [ same | rewrite F; ring ]
            | transitivity (E / 2); [ same | rewrite F; field ]
            | transitivity (- E / 2); [ same | rewrite F; field ] ]
      end
    | apply Rgt_not_eq; unfold Rgt; structure
    | nra
    | apply Rgt_not_eq; interval with (i_prec 80)
    | apply Rlt_not_eq; interval with (i_prec 80) ].

Ltac nonzero := differs ltac:(ring).
Ltac conditions same := repeat split; differs same.

Ltac close :=
  intros;
  solve
    [ assumption
    | lra
    | interval with (i_prec 60)
    | interval with (i_prec 120)
    | interval with (i_prec 300)
    | nonzero
    | field; conditions ltac:(ring) ].

Ltac sign := solve [ assumption | lra | nra | interval | apply pow2_ge_0 ].

(* A product or a quotient whose parts have the signs that are known. *)
Ltac product_sign :=
  unfold Rdiv;
  repeat
    first
      [ assumption
      | lra
      | apply Rmult_lt_0_compat
      | apply Rinv_0_lt_compat
      | apply Rle_mult_inv_pos
      | apply Rmult_le_pos
      | apply pow2_ge_0
      | apply Rlt_le; assumption
      | apply Rlt_le, Rinv_0_lt_compat; lra
      | solve [ nra ] ].

Ltac scale_sign := solve [ lra | nra | product_sign ].

(* An equality as a whole, or that of all arguments of the functions on both sides. *)
Ltac by_parts whole :=
  let as_one := first [ reflexivity | solve [ whole ] ] in
  let below := first [ as_one | progress f_equal; as_one ] in
  first [ as_one | progress f_equal; below ].

(* Facts about a point. *)
Ltac at_point :=
  repeat match goal with |- _ /\ _ => split end;
  first [ close | left; close | right; close ].

(* Sines and cosines of sums by those of the summands. *)
Ltac open_angles :=
  repeat
    rewrite ?sin_plus, ?cos_plus, ?sin_neg, ?cos_neg, ?sine_of_right_angle, ?cosine_of_right_angle
    in *.
