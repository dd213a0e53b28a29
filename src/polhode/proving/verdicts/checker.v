(* A verified checker of stability certificates of polynomial equations with rational coefficients.

A certificate is data. `check_extremum`, `check_symmetry`, `check_growth` and `check_drift` compute, exactly, whether it
proves its verdict. The theorems `confined`, `confined_up_to_turns`, `growing` and `drifting` say what a check that passes
proves about every solution. Needs nothing but Coq's own library. Polhode writes this file beside each certificate. *)
From Coq Require Import Reals QArith Qreals List Lia Lra Ranalysis5 Bool PeanoNat.
Import ListNotations.
Local Open Scope R_scope.

(* ---------------------------------------------------------------- polynomials: sums of coefficient and variables *)

Definition mono := list nat.
Definition poly := list (Q * mono).

Fixpoint eval_mono (x : nat -> R) (m : mono) : R := match m with [] => 1 | i :: m => x i * eval_mono x m end.
Fixpoint eval (x : nat -> R) (p : poly) : R :=
  match p with [] => 0 | (c, m) :: p => Q2R c * eval_mono x m + eval x p end.

Fixpoint insert (i : nat) (m : mono) : mono :=
  match m with [] => [i] | j :: m' => if Nat.leb i j then i :: m else j :: insert i m' end.
Definition times_mono (a b : mono) : mono := fold_right insert b a.
Fixpoint same (a b : mono) : bool :=
  match a, b with [], [] => true | i :: a, j :: b => Nat.eqb i j && same a b | _, _ => false end.
Fixpoint add_term (c : Q) (m : mono) (p : poly) : poly :=
  match p with
  | [] => [(Qred c, m)]
  | (d, k) :: p' => if same m k then (Qred (c + d), k) :: p' else (d, k) :: add_term c m p'
  end.
Definition add (p q : poly) : poly := fold_right (fun t r => add_term (fst t) (snd t) r) q p.
Definition scale_term (c : Q) (m : mono) (p : poly) : poly :=
  map (fun t => (Qred (c * fst t), times_mono m (snd t))) p.
Definition times (p q : poly) : poly := fold_right (fun t r => add (scale_term (fst t) (snd t) q) r) [] p.
Definition scale (c : Q) (p : poly) : poly := scale_term c [] p.
Definition constant (c : Q) : poly := [(c, [])].
Definition variable (i : nat) : poly := [(1%Q, [i])].

Fixpoint shift_mono (z : nat -> Q) (m : mono) : poly :=
  match m with [] => constant 1 | i :: m => times (add (constant (z i)) (variable i)) (shift_mono z m) end.
Definition shift (z : nat -> Q) (p : poly) : poly :=
  fold_right (fun t r => add (scale (fst t) (shift_mono z (snd t))) r) [] p.

(* rate of change along a field *)
Fixpoint rate_mono (f : nat -> poly) (m : mono) : poly :=
  match m with [] => [] | i :: m => add (scale_term 1 m (f i)) (times (variable i) (rate_mono f m)) end.
Definition rate (f : nat -> poly) (p : poly) : poly :=
  fold_right (fun t r => add (scale (fst t) (rate_mono f (snd t))) r) [] p.

Definition is_zero (p : poly) : bool := forallb (fun t => Qeq_bool (fst t) 0) p.
Definition low_vanishes (d : nat) (p : poly) : bool :=
  forallb (fun t => Nat.ltb d (length (snd t)) || Qeq_bool (fst t) 0) p.
Definition magnitude (p : poly) : Q := fold_right (fun t r => Qred (Qabs.Qabs (fst t) + r)) 0%Q p.

Lemma Q2R_red c : Q2R (Qred c) = Q2R c. Proof. apply Qeq_eqR, Qred_correct. Qed.

Lemma eval_insert x i m : eval_mono x (insert i m) = x i * eval_mono x m.
Proof. induction m as [|j m h]; simpl; auto. destruct (Nat.leb i j); simpl; auto. rewrite h; ring. Qed.
Lemma eval_times_mono x a b : eval_mono x (times_mono a b) = eval_mono x a * eval_mono x b.
Proof. induction a as [|i a h]; simpl; [ring|]. rewrite eval_insert, h; ring. Qed.
Lemma same_eq a b : same a b = true -> a = b.
Proof.
  revert b; induction a as [|i a h]; destruct b as [|j b]; simpl; try discriminate; auto.
  intros e; apply andb_prop in e as [e1 e2]; apply Nat.eqb_eq in e1; subst; f_equal; auto. Qed.
Lemma eval_add_term x c m p : eval x (add_term c m p) = Q2R c * eval_mono x m + eval x p.
Proof.
  induction p as [|[d k] p h]; cbn [add_term eval]; [rewrite Q2R_red; ring|].
  destruct (same m k) eqn:e; cbn [eval].
  - apply same_eq in e; subst. rewrite Q2R_red, Q2R_plus; ring.
  - rewrite h; ring. Qed.
Lemma eval_add x p q : eval x (add p q) = eval x p + eval x q.
Proof. induction p as [|[c m] p h]; simpl; [ring|]. rewrite eval_add_term, h; ring. Qed.
Lemma eval_scale_term x c m p : eval x (scale_term c m p) = Q2R c * eval_mono x m * eval x p.
Proof.
  induction p as [|[d k] p h]; cbn [scale_term map eval fst snd]; [ring|].
  change (eval x (map _ p)) with (eval x (scale_term c m p)).
  rewrite h, Q2R_red, Q2R_mult, eval_times_mono; ring. Qed.
Lemma eval_times x p q : eval x (times p q) = eval x p * eval x q.
Proof.
  induction p as [|[c m] p h]; simpl; [ring|].
  change (fold_right _ [] p) with (times p q). rewrite eval_add, eval_scale_term, h; ring. Qed.
Lemma eval_scale x c p : eval x (scale c p) = Q2R c * eval x p.
Proof. unfold scale; rewrite eval_scale_term; simpl; ring. Qed.
Lemma eval_constant x c : eval x (constant c) = Q2R c. Proof. simpl; ring. Qed.
Lemma Q2R_1 : Q2R 1 = 1. Proof. unfold Q2R; simpl; field. Qed.
Lemma Q2R_0 : Q2R 0 = 0. Proof. unfold Q2R; simpl; field. Qed.
Lemma eval_variable x i : eval x (variable i) = x i.
Proof. unfold variable; cbn [eval eval_mono]; rewrite Q2R_1; ring. Qed.
Lemma eval_shift_mono z v m : eval v (shift_mono z m) = eval_mono (fun i => Q2R (z i) + v i) m.
Proof.
  induction m as [|i m h]; cbn [shift_mono eval_mono].
  - rewrite eval_constant; apply Q2R_1.
  - rewrite eval_times, eval_add, eval_constant, eval_variable, h; ring. Qed.
Lemma eval_shift z v p : eval v (shift z p) = eval (fun i => Q2R (z i) + v i) p.
Proof.
  induction p as [|[c m] p h]; auto. unfold shift; cbn [fold_right fst snd eval].
  change (fold_right _ [] p) with (shift z p). rewrite eval_add, eval_scale, eval_shift_mono, h; ring. Qed.
Lemma eval_zero x p : is_zero p = true -> eval x p = 0.
Proof.
  induction p as [|[c m] p h]; simpl; auto. intros e; apply andb_prop in e as [e1 e2].
  rewrite h; auto. apply Qeq_bool_eq in e1. simpl in e1. rewrite (Qeq_eqR _ _ e1), Q2R_0; ring. Qed.
Lemma eval_same p q x : is_zero (add p (scale (-1) q)) = true -> eval x p = eval x q.
Proof.
  intros h. assert (e := eval_zero x _ h). rewrite eval_add, eval_scale in e.
  replace (Q2R (-1)) with (-1) in e by (unfold Q2R; simpl; field). lra. Qed.
Lemma eval_ext x y p : (forall i, x i = y i) -> eval x p = eval y p.
Proof.
  intros e; induction p as [|[c m] p h]; simpl; auto. rewrite h; f_equal; f_equal.
  induction m as [|i m k]; simpl; auto. rewrite e, k; reflexivity. Qed.

(* ---------------------------------------------------------------- bounds near zero *)

Section Bounds.
Variables (v : nat -> R) (N s : R).
Hypotheses (each : forall i, v i * v i <= N) (small : N <= s * s) (s0 : 0 <= s) (s1 : s <= 1).
Lemma N0 : 0 <= N. Proof. apply Rle_trans with (v 0%nat * v 0%nat); [apply Rle_0_sqr | apply each]. Qed.
Lemma entry i : Rabs (v i) <= s.
Proof.
  apply Rsqr_incr_0; [| apply Rabs_pos | assumption]. rewrite <- Rsqr_abs. unfold Rsqr.
  apply Rle_trans with N; auto. Qed.
Lemma mono_bound_1 m : Rabs (eval_mono v m) <= 1.
Proof.
  induction m as [|i m h]; simpl; [rewrite Rabs_R1; lra|]. rewrite Rabs_mult.
  assert (a := entry i). assert (0 <= Rabs (v i)) by apply Rabs_pos.
  apply Rle_trans with (1 * 1); [apply Rmult_le_compat; auto; try apply Rabs_pos; lra | lra]. Qed.
Lemma pair_bound i j : Rabs (v i * v j) <= N.
Proof.
  assert (a := each i). assert (b := each j). assert (c := Rle_0_sqr (v i - v j)). assert (d := Rle_0_sqr (v i + v j)).
  unfold Rsqr in *. apply Rabs_le; split; lra. Qed.
Lemma mono_bound_2 m : (2 <= length m)%nat -> Rabs (eval_mono v m) <= N.
Proof.
  destruct m as [|i [|j m]]; simpl; try lia. intros _. rewrite <- Rmult_assoc, Rabs_mult.
  assert (a := pair_bound i j). assert (b := mono_bound_1 m). assert (0 <= Rabs (v i * v j)) by apply Rabs_pos.
  apply Rle_trans with (N * 1); [apply Rmult_le_compat; auto; apply Rabs_pos | lra]. Qed.
Lemma mono_bound_3 m : (3 <= length m)%nat -> Rabs (eval_mono v m) <= s * N.
Proof.
  destruct m as [|i m]; simpl; try lia. intros l. rewrite Rabs_mult.
  apply Rmult_le_compat; try apply Rabs_pos; [apply entry | apply mono_bound_2; lia]. Qed.
Lemma mono_bound_s m : (1 <= length m)%nat -> Rabs (eval_mono v m) <= s.
Proof.
  destruct m as [|i m]; simpl; try lia. intros _. rewrite Rabs_mult. assert (a := entry i). assert (b := mono_bound_1 m).
  apply Rle_trans with (s * 1); [apply Rmult_le_compat; auto; apply Rabs_pos | lra]. Qed.
Lemma Q2R_abs c : Q2R (Qabs.Qabs c) = Rabs (Q2R c).
Proof.
  destruct (Qlt_le_dec c 0) as [h|h].
  - rewrite Rabs_left; [| rewrite <- Q2R_0; apply Qlt_Rlt; auto].
    rewrite <- Q2R_opp. apply Qeq_eqR. apply Qabs.Qabs_neg, Qlt_le_weak; auto.
  - rewrite Rabs_right; [| rewrite <- Q2R_0; apply Rle_ge, Qle_Rle; auto]. apply Qeq_eqR, Qabs.Qabs_pos; auto. Qed.
Lemma eval_bound d B p : 0 <= B -> (forall m, (d < length m)%nat -> Rabs (eval_mono v m) <= B) ->
  low_vanishes d p = true -> Rabs (eval v p) <= Q2R (magnitude p) * B.
Proof.
  intros b0 b; induction p as [|[c m] p h]; cbn [low_vanishes forallb eval magnitude fold_right fst snd].
  - intros _. rewrite Rabs_R0, Q2R_0; lra.
  - intros e; apply andb_prop in e as [e1 e2]. specialize (h e2).
    rewrite Q2R_red, Q2R_plus, Q2R_abs. fold (magnitude p).
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rmult_plus_distr_r. apply Rplus_le_compat; auto.
    rewrite Rabs_mult. apply orb_prop in e1 as [e1|e1].
    + apply Rmult_le_compat_l; [apply Rabs_pos | apply b, Nat.ltb_lt; auto].
    + apply Qeq_bool_eq in e1. simpl in e1. rewrite (Qeq_eqR _ _ e1), Q2R_0, Rabs_R0; lra. Qed.
Lemma bound_2 p : low_vanishes 1 p = true -> Rabs (eval v p) <= Q2R (magnitude p) * N.
Proof. apply (eval_bound 1); [apply N0 | intros; apply mono_bound_2; lia]. Qed.
Lemma bound_3 p : low_vanishes 2 p = true -> Rabs (eval v p) <= Q2R (magnitude p) * (s * N).
Proof. apply (eval_bound 2); [apply Rmult_le_pos; [auto | apply N0] | intros; apply mono_bound_3; lia]. Qed.
Lemma bound_s p : low_vanishes 0 p = true -> Rabs (eval v p) <= Q2R (magnitude p) * s.
Proof. apply (eval_bound 0); [auto | intros; apply mono_bound_s; lia]. Qed.
End Bounds.

(* squares of linear forms, which are lists of coefficients *)
Fixpoint linear (i : nat) (row : list Q) : poly := match row with [] => [] | c :: row => (c, [i]) :: linear (S i) row end.
Definition squares (l : list (Q * list Q)) : poly :=
  fold_right (fun t r => add (scale (fst t) (times (linear 0 (snd t)) (linear 0 (snd t)))) r) [] l.
Definition all_positive (l : list (Q * list Q)) : bool := forallb (fun t => Qle_bool 0 (fst t)) l.
Lemma squares_nonneg v l : all_positive l = true -> 0 <= eval v (squares l).
Proof.
  induction l as [|[d r] l h]; cbn [squares fold_right all_positive forallb fst snd]; [intros _; simpl; lra|].
  intros e; apply andb_prop in e as [e1 e2]. fold (squares l). rewrite eval_add, eval_scale, eval_times.
  apply Rplus_le_le_0_compat; auto. apply Rmult_le_pos; [| apply Rle_0_sqr].
  rewrite <- Q2R_0; apply Qle_Rle, Qle_bool_iff; auto. Qed.

(* |v|^2 of the first n variables, as number and as polynomial *)
Fixpoint norm (v : nat -> R) (n : nat) : R := match n with O => 0 | S k => norm v k + v k * v k end.
Fixpoint norm_poly (n : nat) : poly := match n with O => [] | S k => (1%Q, [k; k]) :: norm_poly k end.
Lemma eval_norm v n : eval v (norm_poly n) = norm v n.
Proof. induction n as [|k h]; auto. cbn [norm_poly eval eval_mono norm]. rewrite h, Q2R_1; ring. Qed.
Lemma norm_nonneg v n : 0 <= norm v n.
Proof. induction n; simpl; [lra|]. apply Rplus_le_le_0_compat; auto. apply Rle_0_sqr. Qed.
Lemma norm_entry v n i : (i < n)%nat -> v i * v i <= norm v n.
Proof.
  induction n as [|k h]; [lia|]. intros l; simpl. assert (a := Rle_0_sqr (v k)). unfold Rsqr in a.
  destruct (Nat.eq_dec i k) as [->|e]; [assert (b := norm_nonneg v k); lra|]. assert (b := h ltac:(lia)). lra. Qed.
Lemma norm_ext v w n : (forall i, v i = w i) -> norm v n = norm w n.
Proof. intros e; induction n; simpl; auto. rewrite IHn, e; auto. Qed.

(* ---------------------------------------------------------------- solutions *)

Definition equation (f : list poly) (i : nat) : poly := nth i f [].

(* every solution on [0, T] of x' = f(x), with an equation for each variable *)
Definition solves (f : nat -> poly) (x : R -> nat -> R) (T : R) : Prop :=
  forall i t, 0 <= t <= T -> derivable_pt_lim (fun t => x t i) t (eval (x t) (f i)).

Lemma rate_mono_derives f x T m t : solves f x T -> 0 <= t <= T ->
  derivable_pt_lim (fun t => eval_mono (x t) m) t (eval (x t) (rate_mono f m)).
Proof.
  intros so ht; induction m as [|i m h]; cbn [eval_mono rate_mono].
  - apply derivable_pt_lim_const.
  - rewrite eval_add, eval_scale_term, eval_times, eval_variable, Q2R_1.
    replace (1 * eval_mono (x t) m * eval (x t) (f i) + x t i * eval (x t) (rate_mono f m))
      with (eval (x t) (f i) * eval_mono (x t) m + x t i * eval (x t) (rate_mono f m)) by ring.
    apply (derivable_pt_lim_mult (fun t => x t i) (fun t => eval_mono (x t) m)); auto. Qed.
Lemma rate_derives f x T p t : solves f x T -> 0 <= t <= T ->
  derivable_pt_lim (fun t => eval (x t) p) t (eval (x t) (rate f p)).
Proof.
  intros so ht; induction p as [|[c m] p h]; cbn [eval rate fold_right fst snd].
  - apply derivable_pt_lim_const.
  - fold (rate f p). rewrite eval_add, eval_scale.
    apply (derivable_pt_lim_plus (fun t => Q2R c * eval_mono (x t) m) (fun t => eval (x t) p)); auto.
    apply (derivable_pt_lim_scal (fun t => eval_mono (x t) m)). eapply rate_mono_derives; eauto. Qed.

Lemma grows (g h : R -> R) T : (forall t, 0 <= t <= T -> derivable_pt_lim g t (h t)) ->
  forall c, (forall t, 0 <= t <= T -> c <= h t) -> forall t, 0 <= t <= T -> g 0 + c * t <= g t.
Proof.
  intros d c b t ht. destruct (Req_dec t 0) as [->|n]; [lra|].
  destruct (MVT_cor2 g h 0 t) as (u & e & hu); [lra | intros; apply d; lra |].
  assert (c <= h u) by (apply b; lra). assert (c * (t - 0) <= h u * (t - 0)) by (apply Rmult_le_compat_r; lra). lra. Qed.
Lemma constant_along (g h : R -> R) T : (forall t, 0 <= t <= T -> derivable_pt_lim g t (h t)) ->
  (forall t, 0 <= t <= T -> h t = 0) -> forall t, 0 <= t <= T -> g t = g 0.
Proof.
  intros d b t ht. destruct (Req_dec t 0) as [->|n]; auto.
  destruct (MVT_cor2 g h 0 t) as (u & e & hu); [lra | intros; apply d; lra |]. rewrite b in e by lra. lra. Qed.
Lemma conserved f x T p : solves f x T -> is_zero (rate f p) = true ->
  forall t, 0 <= t <= T -> eval (x t) p = eval (x 0) p.
Proof.
  intros so z. apply (constant_along (fun t => eval (x t) p) (fun t => eval (x t) (rate f p))).
  - intros; eapply rate_derives; eauto.
  - intros; apply eval_zero; auto. Qed.
Lemma norm_continuous f x T z n : solves f x T -> forall t, 0 <= t <= T ->
  continuity_pt (fun t => norm (fun i => x t i - Q2R (z i)) n) t.
Proof.
  intros so t ht; induction n as [|k h]; simpl.
  - apply continuity_pt_const; intros ? ?; reflexivity.
  - assert (c : continuity_pt (fun t => x t k - Q2R (z k)) t).
    { apply continuity_pt_minus; [| apply continuity_pt_const; intros ? ?; reflexivity].
      apply derivable_continuous_pt. eexists; apply so; auto. }
    apply continuity_pt_plus; auto. apply continuity_pt_mult; auto. Qed.

(* ---------------------------------------------------------------- the verdicts, about every solution *)

Section Verdicts.
Variables (n : nat) (f : nat -> poly) (z : nat -> Q).
Definition off (x : nat -> R) : R := norm (fun i => x i - Q2R (z i)) n.
Definition inside (x : nat -> R) : Prop := forall i, (n <= i)%nat -> x i = Q2R (z i).

(* Lyapunov: solutions that start near enough stay near *)
Definition stable : Prop := forall eps, 0 < eps -> exists del, 0 < del /\ forall x T, solves f x T ->
  (forall t, 0 <= t <= T -> inside (x t)) -> off (x 0) < del -> forall t, 0 <= t <= T -> off (x t) < eps.

(* arbitrarily near are points from which no solution stays near beyond some time *)
Definition unstable : Prop := exists eps, 0 < eps /\ forall del, 0 < del -> exists p, inside p /\ off p < del /\
  exists end_, forall x T, solves f x T -> (forall t, 0 <= t <= T -> inside (x t)) -> (forall i, x 0 i = p i) ->
  (forall t, 0 <= t <= T -> off (x t) <= eps) -> T <= end_.

Lemma each_entry x : inside x -> forall i, (x i - Q2R (z i)) * (x i - Q2R (z i)) <= off x.
Proof.
  intros h i. destruct (Nat.lt_ge_cases i n) as [l|l]; [unfold off; apply (norm_entry (fun i => x i - Q2R (z i))); auto|].
  rewrite (h i l). unfold Rminus; rewrite Rplus_opp_r, Rmult_0_l. apply norm_nonneg. Qed.
Lemma back x i : Q2R (z i) + (x i - Q2R (z i)) = x i. Proof. ring. Qed.
Lemma eval_back x p : eval (fun i => x i - Q2R (z i)) (shift z p) = eval x p.
Proof. rewrite eval_shift; apply eval_ext; intros; apply back. Qed.

Section Confined.
(* extra vanishes where the minimum is looked for: everywhere if it is [], else across the orbit of a symmetry *)
Variables (g extra : poly) (l : list (Q * list Q)) (m s : Q).
Definition here : poly := shift z g.
Definition level : Q := fold_right (fun t r => match snd t with [] => Qred (fst t + r) | _ => r end) 0%Q here.
Definition raised : poly := add (add here (constant (- level))) extra.
Definition rest : poly := add raised (scale (-1) (add (scale m (norm_poly n)) (squares l))).
Definition check_extremum : bool :=
  low_vanishes 1 raised && low_vanishes 2 rest && all_positive l && Qle_bool s 1 && negb (Qle_bool s 0) &&
  negb (Qle_bool (m - magnitude rest * s) 0).
Hypothesis checked : check_extremum = true.

Lemma parts : low_vanishes 1 raised = true /\ low_vanishes 2 rest = true /\ all_positive l = true /\
  Q2R s <= 1 /\ 0 < Q2R s /\ 0 < Q2R (m - magnitude rest * s).
Proof.
  unfold check_extremum in checked. apply andb_prop in checked as [c c6]. apply andb_prop in c as [c c5].
  apply andb_prop in c as [c c4]. apply andb_prop in c as [c c3]. apply andb_prop in c as [c1 c2].
  assert (pos : forall q, negb (Qle_bool q 0) = true -> 0 < Q2R q).
  { intros q h. rewrite <- Q2R_0; apply Qlt_Rlt, Qnot_le_lt. intro k; apply Qle_bool_iff in k; rewrite k in h; discriminate. }
  repeat split; auto. rewrite <- Q2R_1; apply Qle_Rle, Qle_bool_iff; auto. Qed.
Definition least : R := Q2R (m - magnitude rest * s).
Definition most : R := Q2R (magnitude raised) + 1.
Definition radius : R := Q2R s * Q2R s.
Lemma magnitude_nonneg p : 0 <= Q2R (magnitude p).
Proof.
  induction p as [|[c k] p h]; cbn [magnitude fold_right fst snd]; [rewrite Q2R_0; lra|].
  fold (magnitude p). rewrite Q2R_red, Q2R_plus, Q2R_abs. assert (a := Rabs_pos (Q2R c)). lra. Qed.
Lemma pinch x : inside x -> off x <= radius -> eval (fun i => x i - Q2R (z i)) extra = 0 ->
  least * off x <= eval x g - Q2R level <= most * off x.
Proof.
  intros h r x0. destruct parts as (p1 & p2 & p3 & p4 & p5 & p6). set (v := fun i => x i - Q2R (z i)).
  assert (e : eval x g - Q2R level = eval v raised).
  { unfold raised. rewrite !eval_add, eval_constant. unfold here, v. rewrite x0, eval_back, Q2R_opp; ring. }
  assert (each := each_entry x h). fold v in each. change (forall i, v i * v i <= off x) in each.
  assert (n0 : 0 <= off x) by apply norm_nonneg.
  assert (u := bound_2 v (off x) (Q2R s) each r ltac:(lra) p4 raised p1).
  assert (w := bound_3 v (off x) (Q2R s) each r ltac:(lra) p4 rest p2).
  assert (q := squares_nonneg v l p3).
  assert (k : eval v raised = Q2R m * off x + eval v (squares l) + eval v rest).
  { unfold rest. rewrite !eval_add, !eval_scale, eval_add, eval_scale, eval_norm. unfold off, v.
    replace (Q2R (-1)) with (-1) by (unfold Q2R; simpl; field). ring. }
  rewrite e. split.
  - unfold least. rewrite Q2R_minus, Q2R_mult. rewrite k.
    assert (- (Q2R (magnitude rest) * (Q2R s * off x)) <= eval v rest) by (unfold Rabs in w; destruct (Rcase_abs (eval v rest)); lra).
    lra.
  - unfold most. assert (eval v raised <= Rabs (eval v raised)) by apply Rle_abs. lra. Qed.

Lemma constants : 0 < radius /\ 0 < least /\ 0 < most.
Proof.
  destruct parts as (_ & _ & _ & p4 & p5 & p6). assert (a := magnitude_nonneg raised).
  repeat split; [unfold radius; apply Rmult_lt_0_compat; auto | exact p6 | unfold most; lra]. Qed.
End Confined.

Theorem confined g l m s : check_extremum g [] l m s = true -> is_zero (rate f g) = true -> stable.
Proof.
  intros checked cons eps pe. destruct (constants g [] l m s checked) as (pr & pm & pM).
  set (radius := radius s) in *. set (least := least g [] l m s) in *. set (most := most g []) in *.
  set (e := Rmin eps radius). assert (pe' : 0 < e) by (unfold e; apply Rmin_glb_lt; auto).
  assert (e1 : e <= eps) by apply Rmin_l. assert (e2 : e <= radius) by apply Rmin_r.
  set (d := Rmin e (least * e / most)).
  assert (q0 : 0 < least * e / most) by (apply Rdiv_lt_0_compat; auto; apply Rmult_lt_0_compat; auto).
  assert (pd : 0 < d) by (unfold d; apply Rmin_glb_lt; auto).
  assert (d1 : d <= e) by apply Rmin_l. assert (d2 : d <= least * e / most) by apply Rmin_r.
  exists d; split; auto. intros x T so ins h0 t ht.
  destruct (Rlt_le_dec (off (x t)) e) as [k|k]; [lra|]. exfalso.
  assert (nt : 0 < t) by (destruct (Req_dec t 0) as [->|]; lra).
  assert (X : exists s, 0 <= s <= T /\ off (x s) = e).
  { destruct k as [k|k]; [|exists t; split; auto; lra].
    destruct (IVT_interv (fun s => off (x s) - e) 0 t) as (c & hc & q); try lra.
    - intros a ha. apply continuity_pt_minus; [apply (norm_continuous f x T z n so); lra |
        apply continuity_pt_const; intros ? ?; reflexivity].
    - exists c; split; lra. }
  destruct X as (c & hc & q). assert (a := pinch g [] l m s checked (x c) (ins c hc) ltac:(fold radius; lra) eq_refl).
  assert (b := pinch g [] l m s checked (x 0) (ins 0 ltac:(lra)) ltac:(fold radius; lra) eq_refl).
  fold least most in a, b.
  rewrite (conserved f x T g so cons c hc), q in a.
  assert (most * off (x 0) < least * e); [|lra].
  apply Rlt_le_trans with (most * (least * e / most)); [apply Rmult_lt_compat_l; lra | right; field; lra]. Qed.

(* -------- growth: V' >= 2 gamma V near z, and V > 0 arbitrarily near; drift: V' >= K q with K conserved and positive *)

Definition around (i : nat) : poly := shift z (f i).
Definition quadratic (p : poly) : bool := forallb (fun t => Nat.eqb (length (snd t)) 2) p.
Definition entry_of (u : list Q) (i : nat) : Q := nth i u 0%Q.
Fixpoint value_mono (u : nat -> Q) (m : mono) : Q := match m with [] => 1%Q | i :: m => Qred (u i * value_mono u m) end.
Fixpoint value (u : nat -> Q) (p : poly) : Q :=
  match p with [] => 0%Q | (c, m) :: p => Qred (c * value_mono u m + value u p) end.
Lemma eval_value u p : Q2R (value u p) = eval (fun i => Q2R (u i)) p.
Proof.
  induction p as [|[c m] p h]; cbn [value eval]; [apply Q2R_0|]. rewrite Q2R_red, Q2R_plus, Q2R_mult, h. do 2 f_equal.
  clear; induction m as [|i m h]; cbn [value_mono eval_mono]; [apply Q2R_1|]. rewrite Q2R_red, Q2R_mult, h; auto. Qed.
Lemma quadratic_scales v r p : quadratic p = true -> eval (fun i => r * v i) p = r * r * eval v p.
Proof.
  induction p as [|[c m] p h]; cbn [quadratic forallb eval snd]; [intros; ring|].
  intros e; apply andb_prop in e as [e1 e2]. rewrite (h e2). apply Nat.eqb_eq in e1.
  destruct m as [|i [|j [|k m]]]; try discriminate. cbn [eval_mono]. ring. Qed.
Lemma quadratic_low p : quadratic p = true -> low_vanishes 1 p = true.
Proof.
  unfold quadratic, low_vanishes; rewrite !forallb_forall; intros h t ht. apply orb_true_intro; left.
  apply Nat.ltb_lt. rewrite (proj1 (Nat.eqb_eq _ _) (h t ht)); lia. Qed.
Lemma norm_scales v r k : norm (fun i => r * v i) k = r * r * norm v k.
Proof. induction k; simpl; [ring | rewrite IHk; ring]. Qed.
Lemma Rabs_low y b : Rabs y <= b -> - b <= y.
Proof. unfold Rabs; destruct (Rcase_abs y); lra. Qed.
Lemma positive q : negb (Qle_bool q 0) = true -> 0 < Q2R q.
Proof.
  intros h. rewrite <- Q2R_0; apply Qlt_Rlt, Qnot_le_lt. intro k; apply Qle_bool_iff in k; rewrite k in h; discriminate. Qed.

Definition from (x : R -> nat -> R) (t : R) (i : nat) : R := x t i - Q2R (z i).
Lemma solves_around x T : solves f x T -> solves around (from x) T.
Proof.
  intros so i t ht. unfold around. change (from x t) with (fun i => x t i - Q2R (z i)). rewrite eval_back.
  replace (eval (x t) (f i)) with (eval (x t) (f i) - 0) by ring.
  apply (derivable_pt_lim_minus (fun t => x t i) (fun _ => Q2R (z i))); [apply so; auto | apply derivable_pt_lim_const]. Qed.

(* a point on the ray of u, nearer than del *)
Lemma ray (u : list Q) del : (length u <= n)%nat -> 0 < del -> exists r, 0 < r /\
  inside (fun i => Q2R (z i) + r * Q2R (entry_of u i)) /\ off (fun i => Q2R (z i) + r * Q2R (entry_of u i)) < del.
Proof.
  intros lu pd. set (a := norm (fun i => Q2R (entry_of u i)) n). assert (a0 : 0 <= a) by apply norm_nonneg.
  set (r := Rmin 1 (del / (a + 1))). assert (pq : 0 < del / (a + 1)) by (apply Rdiv_lt_0_compat; lra).
  assert (pr : 0 < r) by (unfold r; apply Rmin_glb_lt; lra).
  assert (r1 : r <= 1) by apply Rmin_l. assert (r2 : r <= del / (a + 1)) by apply Rmin_r.
  exists r; split; auto. split.
  - intros i hi. unfold entry_of. rewrite nth_overflow by lia. rewrite Q2R_0; ring.
  - unfold off. rewrite (norm_ext _ (fun i => r * Q2R (entry_of u i))) by (intros; ring).
    rewrite (norm_scales (fun i => Q2R (entry_of u i))). fold a.
    assert (r * (a + 1) <= del).
    { apply Rle_trans with (del / (a + 1) * (a + 1)); [apply Rmult_le_compat_r; lra | right; field; lra]. }
    assert (r * r * a <= r * a) by (apply Rmult_le_compat_r; auto; assert (r * r <= 1 * r) by (apply Rmult_le_compat_r; lra); lra).
    lra. Qed.

Section Leaving.
Variables (V : poly) (u : list Q) (s : Q).

(* what every way to leave has in common: V stays bounded near z, so it cannot grow for ever *)
Definition check_leaving : bool :=
  quadratic V && Nat.leb (length u) n && Qle_bool s 1 && negb (Qle_bool s 0).
Lemma leaving_parts : check_leaving = true ->
  quadratic V = true /\ (length u <= n)%nat /\ Q2R s <= 1 /\ 0 < Q2R s.
Proof.
  unfold check_leaving; intros c. apply andb_prop in c as [c c4]. apply andb_prop in c as [c c3].
  apply andb_prop in c as [c1 c2]. repeat split; auto.
  - apply Nat.leb_le; auto.
  - rewrite <- Q2R_1; apply Qle_Rle, Qle_bool_iff; auto.
  - apply positive; auto. Qed.
Lemma leave (k : R -> R) : check_leaving = true -> (forall r, 0 < r -> 0 < k r) ->
  (forall x T r, 0 < r -> solves f x T -> (forall t, 0 <= t <= T -> inside (x t)) ->
    (forall i, x 0 i = Q2R (z i) + r * Q2R (entry_of u i)) ->
    (forall t, 0 <= t <= T -> off (x t) <= Q2R s * Q2R s) ->
    forall t, 0 <= t <= T -> k r <= eval (from x t) (rate around V)) -> unstable.
Proof.
  intros c pk fast. destruct (leaving_parts c) as (c1 & c2 & c3 & c4).
  exists (Q2R s * Q2R s); split; [apply Rmult_lt_0_compat; auto|]. intros del pd.
  destruct (ray u del c2 pd) as (r & pr & ins & near).
  exists (fun i => Q2R (z i) + r * Q2R (entry_of u i)); repeat split; auto.
  set (b := Q2R (magnitude V) * (Q2R s * Q2R s)). exists (2 * b / k r).
  intros x T so hi h0 st. destruct (Rlt_le_dec T 0) as [neg|pT].
  { apply Rle_trans with 0; [lra|]. apply Rmult_le_pos; [| left; apply Rinv_0_lt_compat; auto].
    assert (0 <= b); [|lra]. apply Rmult_le_pos; [apply magnitude_nonneg | apply Rmult_le_pos; lra]. }
  assert (bound : forall t, 0 <= t <= T -> Rabs (eval (from x t) V) <= b).
  { intros t ht. eapply Rle_trans.
    - apply (bound_2 (from x t) (off (x t)) (Q2R s)); auto; try lra; [apply each_entry; auto | apply quadratic_low; auto].
    - apply Rmult_le_compat_l; [apply magnitude_nonneg | auto]. }
  assert (g := grows (fun t => eval (from x t) V) (fun t => eval (from x t) (rate around V)) T
    (fun t ht => rate_derives around (from x) T V t (solves_around x T so) ht) (k r)
    (fast x T r pr so hi h0 st) T ltac:(lra)). cbv beta in g.
  assert (b1 := bound T ltac:(lra)). assert (b2 := bound 0 ltac:(lra)).
  assert (k r * T <= 2 * b).
  { unfold Rabs in b1, b2. destruct (Rcase_abs (eval (from x T) V)), (Rcase_abs (eval (from x 0) V)); lra. }
  assert (p := pk r pr). apply Rmult_le_reg_l with (k r); auto. replace (k r * (2 * b / k r)) with (2 * b) by (field; lra). auto. Qed.

Lemma start (x : R -> nat -> R) r p : quadratic p = true ->
  (forall i, x 0 i = Q2R (z i) + r * Q2R (entry_of u i)) -> eval (from x 0) p = r * r * Q2R (value (entry_of u) p).
Proof.
  intros q h. rewrite eval_value, <- (quadratic_scales _ _ _ q). apply eval_ext; intros i. unfold from. rewrite h; ring. Qed.

Section Growth.
Variables (gamma m : Q) (l : list (Q * list Q)).
Definition excess : poly :=
  add (rate around V) (scale (-1) (add (scale (2 * gamma) V) (add (scale m (norm_poly n)) (squares l)))).
Definition check_growth : bool :=
  check_leaving && low_vanishes 2 excess && all_positive l && negb (Qle_bool gamma 0) &&
  Qle_bool (magnitude excess * s) m && negb (Qle_bool (value (entry_of u) V) 0).
Theorem growing : check_growth = true -> unstable.
Proof.
  intros c. unfold check_growth in c. apply andb_prop in c as [c c6]. apply andb_prop in c as [c c5].
  apply andb_prop in c as [c c4]. apply andb_prop in c as [c c3]. apply andb_prop in c as [c1 c2].
  apply positive in c4. apply positive in c6. apply Qle_bool_iff, Qle_Rle in c5. rewrite Q2R_mult in c5.
  destruct (leaving_parts c1) as (d1 & d2 & d3 & d4). set (w := Q2R (value (entry_of u) V)) in *.
  apply (leave (fun r => 2 * Q2R gamma * (r * r * w)) c1).
  { intros r pr. apply Rmult_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; auto | exact c6]. }
  intros x T r pr so hi h0 st.
  assert (fast : forall t, 0 <= t <= T -> 2 * Q2R gamma * eval (from x t) V <= eval (from x t) (rate around V)).
  { intros t ht. assert (q := squares_nonneg (from x t) l c3).
    assert (o := norm_nonneg (from x t) n). change (norm (from x t) n) with (off (x t)) in o.
    assert (b := bound_3 (from x t) (off (x t)) (Q2R s) (each_entry _ (hi t ht)) (st t ht) ltac:(lra) d3 excess c2).
    assert (e : eval (from x t) (rate around V) = 2 * Q2R gamma * eval (from x t) V + Q2R m * off (x t) +
      eval (from x t) (squares l) + eval (from x t) excess).
    { unfold excess. rewrite !eval_add, !eval_scale, !eval_add, !eval_scale, eval_norm, Q2R_mult.
      change (norm (from x t) n) with (off (x t)).
      replace (Q2R (-1)) with (-1) by (unfold Q2R; simpl; field). replace (Q2R 2) with 2 by (unfold Q2R; simpl; field). ring. }
    assert (Q2R (magnitude excess) * (Q2R s * off (x t)) <= Q2R m * off (x t)).
    { rewrite <- Rmult_assoc. apply Rmult_le_compat_r; auto. }
    unfold Rabs in b. destruct (Rcase_abs (eval (from x t) excess)); lra. }
  assert (v0 : eval (from x 0) V = r * r * w) by (apply start; auto).
  assert (p0 : 0 < r * r * w) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; auto | exact c6]).
  (* V exp(-2 gamma t) does not fall, so V stays positive; then V does not fall *)
  assert (pos : forall t, 0 <= t <= T -> 0 < eval (from x t) V).
  { intros t ht. set (a := - (2 * Q2R gamma)).
    assert (g := grows (fun t => eval (from x t) V * exp (a * t))
      (fun t => eval (from x t) (rate around V) * exp (a * t) + eval (from x t) V * (exp (a * t) * a)) T).
    assert (g0 : eval (from x 0) V * exp (a * 0) + 0 * t <= eval (from x t) V * exp (a * t)).
    { apply g; auto.
      - intros r0 hr. apply (derivable_pt_lim_mult (fun t => eval (from x t) V) (fun t => exp (a * t))).
        + eapply rate_derives; [apply solves_around; eauto | auto].
        + apply (derivable_pt_lim_comp (fun t => a * t) exp); [| apply derivable_pt_lim_exp].
          assert (d := derivable_pt_lim_scal (fun t => t) a r0 1 (derivable_pt_lim_id r0)). rewrite Rmult_1_r in d. exact d.
      - intros r0 hr. assert (k := fast r0 hr). assert (e := exp_pos (a * r0)).
        replace (eval (from x r0) (rate around V) * exp (a * r0) + eval (from x r0) V * (exp (a * r0) * a))
          with (exp (a * r0) * (eval (from x r0) (rate around V) - 2 * Q2R gamma * eval (from x r0) V)) by (unfold a; ring).
        apply Rmult_le_pos; lra. }
    rewrite Rmult_0_r, exp_0, v0 in g0. assert (e := exp_pos (a * t)).
    apply Rmult_lt_reg_r with (exp (a * t)); lra. }
  intros t ht. apply Rle_trans with (2 := fast t ht). apply Rmult_le_compat_l; [lra|]. rewrite <- v0.
  assert (g := grows (fun t => eval (from x t) V) (fun t => eval (from x t) (rate around V)) T
    (fun t ht => rate_derives around (from x) T V t (solves_around x T so) ht) 0).
  assert (g0 : eval (from x 0) V + 0 * t <= eval (from x t) V); [|lra]. apply g; auto.
  intros a ha. assert (k := fast a ha). assert (p := pos a ha).
  apply Rle_trans with (2 := k). apply Rmult_le_pos; lra. Qed.
End Growth.

Section Drift.
Variables (K q : poly).
Definition rises : poly := add q (constant (- value (fun _ => 0%Q) q)).
Definition check_drift : bool :=
  check_leaving && quadratic K && is_zero (rate around K) &&
  is_zero (add (rate around V) (scale (-1) (times K q))) && low_vanishes 0 rises &&
  negb (Qle_bool (value (fun _ => 0%Q) q - magnitude rises * s) 0) && negb (Qle_bool (value (entry_of u) K) 0).
Theorem drifting : check_drift = true -> unstable.
Proof.
  intros c. unfold check_drift in c. apply andb_prop in c as [c c7]. apply andb_prop in c as [c c6].
  apply andb_prop in c as [c c5]. apply andb_prop in c as [c c4]. apply andb_prop in c as [c c3].
  apply andb_prop in c as [c1 c2]. apply positive in c7. apply positive in c6. rewrite Q2R_minus, Q2R_mult in c6.
  destruct (leaving_parts c1) as (d1 & d2 & d3 & d4). set (w := Q2R (value (entry_of u) K)) in *.
  set (q0 := Q2R (value (fun _ => 0%Q) q)) in *. set (a := q0 - Q2R (magnitude rises) * Q2R s) in *.
  apply (leave (fun r => r * r * w * a) c1).
  { intros r pr. apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; auto | exact c7] | exact c6]. }
  intros x T r pr so hi h0 st t ht.
  assert (e := eval_zero (from x t) _ c4). rewrite eval_add, eval_scale, eval_times in e.
  replace (Q2R (-1)) with (-1) in e by (unfold Q2R; simpl; field).
  assert (k := conserved around (from x) T K (solves_around x T so) c3 t ht). rewrite (start x r K c2 h0) in k. fold w in k.
  assert (b := bound_s (from x t) (off (x t)) (Q2R s) (each_entry _ (hi t ht)) (st t ht) ltac:(lra) d3 rises c5).
  unfold rises in b at 1. rewrite eval_add, eval_constant, Q2R_opp in b. fold q0 in b.
  assert (a <= eval (from x t) q) by (assert (y := Rabs_low _ _ b); unfold a; lra).
  replace (eval (from x t) (rate around V)) with (eval (from x t) K * eval (from x t) q) by lra. rewrite k.
  apply Rmult_le_compat_l; auto.
  left; apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; auto | exact c7]. Qed.
End Drift.
End Leaving.

(* -------- up to a symmetry: X turns points, x + sin a Xx + (1 - cos a) XXx, and keeps the field, |x| and G *)

Section Symmetry.
Variable X : list poly.
Definition X1 : nat -> poly := equation X.
Definition X2 (i : nat) : poly := rate X1 (X1 i).
Definition turn (a : R) (x : nat -> R) (i : nat) : R :=
  x i + sin a * eval x (X1 i) + (1 - cos a) * eval x (X2 i).
Definition linear_poly (p : poly) : bool := forallb (fun t => Nat.eqb (length (snd t)) 1) p.
Fixpoint paired (P : nat -> poly) (k : nat) : poly :=
  match k with O => [] | S k => add (paired P k) (scale (z k) (P k)) end.
Definition across : poly := paired X1 n.
Definition check_symmetry : bool :=
  Nat.leb (length X) n && forallb linear_poly X && is_zero (rate X1 (norm_poly n)) &&
  forallb (fun i => is_zero (add (rate X2 (X1 i)) (X1 i))) (seq 0 n).

Lemma linear_eval a b c s d p : linear_poly p = true ->
  eval (fun i => a i + s * b i + d * c i) p = eval a p + s * eval b p + d * eval c p.
Proof.
  induction p as [|[q m] p h]; cbn [linear_poly forallb eval snd]; [intros; ring|].
  intros e; apply andb_prop in e as [e1 e2]. rewrite (h e2). apply Nat.eqb_eq in e1.
  destruct m as [|i [|j m]]; try discriminate. cbn [eval_mono]. ring. Qed.
Lemma linear_rate F x p : linear_poly p = true -> eval x (rate F p) = eval (fun i => eval x (F i)) p.
Proof.
  induction p as [|[q m] p h]; cbn [linear_poly forallb eval snd]; [auto|].
  intros e; apply andb_prop in e as [e1 e2]. apply Nat.eqb_eq in e1. destruct m as [|i [|j m]]; try discriminate.
  unfold rate; cbn [fold_right fst snd]. fold (rate F p). rewrite eval_add, eval_scale, (h e2).
  cbn [rate_mono eval_mono]. rewrite eval_add, eval_scale_term, eval_times, Q2R_1. cbn [eval_mono eval]. ring. Qed.

Hypothesis symmetric : check_symmetry = true.
Lemma symmetry_parts : (length X <= n)%nat /\ (forall i, linear_poly (X1 i) = true) /\
  is_zero (rate X1 (norm_poly n)) = true /\ forall i x, eval x (rate X2 (X1 i)) = - eval x (X1 i).
Proof.
  unfold check_symmetry in symmetric. apply andb_prop in symmetric as [c c4]. apply andb_prop in c as [c c3].
  apply andb_prop in c as [c1 c2]. apply Nat.leb_le in c1. rewrite forallb_forall in c2, c4.
  refine (conj c1 (conj _ (conj c3 _))).
  - intros i. unfold X1, equation. destruct (Nat.lt_ge_cases i (length X)); [apply c2, nth_In; auto|].
    rewrite nth_overflow; auto.
  - intros i x. destruct (Nat.lt_ge_cases i n).
    + assert (k := eval_zero x _ (c4 i ltac:(apply in_seq; lia))). rewrite eval_add in k. lra.
    + unfold X1, equation. rewrite nth_overflow by lia. simpl; ring. Qed.

Lemma turn_solves x T : solves X1 (fun a => turn a x) T.
Proof.
  destruct symmetry_parts as (_ & lin & _ & cube). intros i a _. unfold turn at 2.
  rewrite (linear_eval x (fun i => eval x (X1 i)) (fun i => eval x (X2 i)) (sin a) (1 - cos a) (X1 i) (lin i)).
  rewrite <- (linear_rate X1 x (X1 i) (lin i)), <- (linear_rate X2 x (X1 i) (lin i)), cube. fold (X2 i).
  replace (eval x (X1 i) + sin a * eval x (X2 i) + (1 - cos a) * - eval x (X1 i))
    with (0 + cos a * eval x (X1 i) + (0 - (- sin a)) * eval x (X2 i)) by ring.
  unfold turn. apply (derivable_pt_lim_plus (fun a => x i + sin a * eval x (X1 i)) (fun a => (1 - cos a) * eval x (X2 i))).
  - apply (derivable_pt_lim_plus (fun _ => x i) (fun a => sin a * eval x (X1 i))); [apply derivable_pt_lim_const|].
    replace (cos a * eval x (X1 i)) with (cos a * eval x (X1 i) + sin a * 0) by ring.
    apply (derivable_pt_lim_mult sin (fun _ => eval x (X1 i))); [apply derivable_pt_lim_sin | apply derivable_pt_lim_const].
  - replace ((0 - - sin a) * eval x (X2 i)) with ((0 - - sin a) * eval x (X2 i) + (1 - cos a) * 0) by ring.
    apply (derivable_pt_lim_mult (fun a => 1 - cos a) (fun _ => eval x (X2 i))); [| apply derivable_pt_lim_const].
    apply (derivable_pt_lim_minus (fun _ => 1) cos); [apply derivable_pt_lim_const | apply derivable_pt_lim_cos]. Qed.
Lemma turn_0 x i : turn 0 x i = x i.
Proof. unfold turn. rewrite sin_0, cos_0; ring. Qed.
Lemma turn_keeps x p a : 0 <= a -> is_zero (rate X1 p) = true -> eval (turn a x) p = eval x p.
Proof.
  intros pa k. rewrite (conserved X1 (fun a => turn a x) a p (turn_solves x a) k a (conj pa (Rle_refl a))).
  apply eval_ext, turn_0. Qed.
Lemma turn_inside x a : inside x -> inside (turn a x).
Proof.
  destruct symmetry_parts as (l & _ & _ & _). intros h i hi. unfold turn, X2, X1, equation.
  rewrite nth_overflow by lia. simpl. rewrite (h i hi); ring. Qed.

(* the distance from z to the nearest turned point, and the turn *)
Definition lin (x : nat -> R) : R := eval x (paired variable n).
Definition c1 (x : nat -> R) : R := eval x across.
Definition c2 (x : nat -> R) : R := eval x (paired X2 n).
Definition nearest (x : nat -> R) : R := eval x (norm_poly n) + norm (fun i => Q2R (z i)) n -
  2 * (lin x + c2 x + sqrt (c1 x * c1 x + c2 x * c2 x)).
Lemma paired_turn P x a k : (forall i, linear_poly (P i) = true) ->
  eval (turn a x) (paired P k) = eval x (paired P k) + sin a * eval (fun i => eval x (X1 i)) (paired P k) +
  (1 - cos a) * eval (fun i => eval x (X2 i)) (paired P k).
Proof.
  intros l; induction k as [|k h]; cbn [paired]; [simpl; ring|]. rewrite !eval_add, !eval_scale, h. unfold turn at 1.
  rewrite (linear_eval x (fun i => eval x (X1 i)) (fun i => eval x (X2 i)) (sin a) (1 - cos a) (P k) (l k)). ring. Qed.
Lemma paired_subst P F x k : (forall i, linear_poly (P i) = true) ->
  eval (fun i => eval x (F i)) (paired P k) = eval x (paired (fun i => rate F (P i)) k).
Proof.
  intros l; induction k as [|k h]; cbn [paired]; auto. rewrite !eval_add, !eval_scale, h, linear_rate; auto. Qed.
Lemma paired_ext P P' x k : (forall i, eval x (P i) = eval x (P' i)) -> eval x (paired P k) = eval x (paired P' k).
Proof. intros e; induction k as [|k h]; cbn [paired]; auto. rewrite !eval_add, !eval_scale, h, e; auto. Qed.
Lemma paired_opp P P' x k : (forall i, eval x (P i) = - eval x (P' i)) -> eval x (paired P k) = - eval x (paired P' k).
Proof. intros e; induction k as [|k h]; cbn [paired]; [simpl; ring|]. rewrite !eval_add, !eval_scale, h, e; ring. Qed.
Lemma variable_rate F x i : eval x (rate F (variable i)) = eval x (F i).
Proof. rewrite linear_rate by reflexivity. rewrite eval_variable; auto. Qed.
Lemma lin_turn x a : lin (turn a x) = lin x + sin a * c1 x + (1 - cos a) * c2 x.
Proof.
  unfold lin, c1, c2, across. rewrite paired_turn by reflexivity. rewrite !paired_subst by reflexivity.
  rewrite (paired_ext (fun i => rate X1 (variable i)) X1) by (intros; apply variable_rate).
  rewrite (paired_ext (fun i => rate X2 (variable i)) X2) by (intros; apply variable_rate). auto. Qed.
Lemma c1_turn x a : c1 (turn a x) = cos a * c1 x + sin a * c2 x.
Proof.
  destruct symmetry_parts as (_ & l & _ & cube). unfold c1, c2, across. rewrite paired_turn by auto.
  rewrite !paired_subst by auto. rewrite (paired_opp (fun i => rate X2 (X1 i)) X1) by (intros; apply cube).
  change (fun i => rate X1 (X1 i)) with X2. ring. Qed.
Lemma off_expands x k : norm (fun i => x i - Q2R (z i)) k =
  norm x k + norm (fun i => Q2R (z i)) k - 2 * eval x (paired variable k).
Proof.
  induction k as [|k h]; cbn [norm paired]; [simpl; ring|]. rewrite h, eval_add, eval_scale, eval_variable; ring. Qed.
Lemma off_turn x a : 0 <= a -> off (turn a x) =
  eval x (norm_poly n) + norm (fun i => Q2R (z i)) n - 2 * (lin x + c2 x + (sin a * c1 x - cos a * c2 x)).
Proof.
  intros pa. destruct symmetry_parts as (_ & _ & iso & _). unfold off. rewrite off_expands, <- eval_norm.
  rewrite (turn_keeps x (norm_poly n) a pa iso). fold (lin (turn a x)). rewrite lin_turn. ring. Qed.

Lemma best x : exists a, 0 <= a /\ off (turn a x) = nearest x /\ c1 (turn a x) = 0.
Proof.
  set (r := sqrt (c1 x * c1 x + c2 x * c2 x)).
  assert (q1 := Rle_0_sqr (c1 x)). assert (q2 := Rle_0_sqr (c2 x)). unfold Rsqr in q1, q2.
  assert (r2 : r * r = c1 x * c1 x + c2 x * c2 x) by (apply sqrt_sqrt; lra).
  assert (r0 : 0 <= r) by apply sqrt_pos.
  destruct (Req_dec r 0) as [e|ne].
  - assert (z1 : c1 x = 0) by (apply Rsqr_0_uniq; unfold Rsqr; rewrite e in r2; lra).
    assert (z2 : c2 x = 0) by (apply Rsqr_0_uniq; unfold Rsqr; rewrite e in r2; lra).
    exists 0. rewrite (off_turn x 0 (Rle_refl 0)), c1_turn, z1, z2. unfold nearest; fold r. rewrite e, z2, cos_0.
    repeat split; lra.
  - set (w := - c2 x / r). assert (pr : 0 < r) by lra.
    assert (w2 : w * w + (c1 x / r) * (c1 x / r) = 1).
    { unfold w. replace (- c2 x / r * (- c2 x / r) + c1 x / r * (c1 x / r)) with ((c1 x * c1 x + c2 x * c2 x) / (r * r))
        by (field; auto). rewrite <- r2. field; auto. }
    assert (wb : -1 <= w <= 1).
    { assert (h := Rle_0_sqr (c1 x / r)). unfold Rsqr in h. split; apply Rnot_lt_le; intros k;
      [assert (1 * 1 < (- w) * (- w)) by (apply Rmult_le_0_lt_compat; lra) |
       assert (1 * 1 < w * w) by (apply Rmult_le_0_lt_compat; lra)]; lra. }
    assert (A : exists a, 0 <= a /\ cos a = w /\ sin a = c1 x / r).
    { assert (bd := acos_bound w). assert (ca := cos_acos w wb).
      assert (sa : sin (acos w) = Rabs (c1 x / r)).
      { rewrite sin_acos by auto. replace (1 - w²) with ((c1 x / r)²) by (unfold Rsqr; lra). apply sqrt_Rsqr_abs. }
      destruct (Rle_dec 0 (c1 x / r)) as [k|k].
      - exists (acos w). rewrite sa, Rabs_right by lra. repeat split; auto; lra.
      - exists (2 * PI - acos w). assert (p := PI_RGT_0). repeat split; [lra | |].
        + rewrite cos_minus, cos_2PI, sin_2PI, ca; ring.
        + rewrite sin_minus, cos_2PI, sin_2PI, sa, Rabs_left by lra; ring. }
    destruct A as (a & pa & ca & sa). exists a. refine (conj pa (conj _ _)).
    + rewrite (off_turn x a pa), ca, sa. unfold nearest; fold r.
      replace (c1 x / r * c1 x - w * c2 x) with ((c1 x * c1 x + c2 x * c2 x) / r) by (unfold w; field; auto).
      rewrite <- r2. field_simplify; auto.
    + rewrite c1_turn, ca, sa. unfold w. field; auto. Qed.
Lemma nearest_least x : nearest x <= off x.
Proof.
  assert (e : off x = off (turn 0 x)) by (unfold off; apply norm_ext; intros; rewrite turn_0; auto).
  rewrite e, (off_turn x 0 (Rle_refl 0)), sin_0, cos_0. unfold nearest.
  assert (q1 := Rle_0_sqr (c1 x)). unfold Rsqr in q1.
  assert (- c2 x <= sqrt (c1 x * c1 x + c2 x * c2 x)); [|lra].
  apply Rle_trans with (sqrt (c2 x * c2 x)); [| apply sqrt_le_1; assert (q2 := Rle_0_sqr (c2 x)); unfold Rsqr in q2; lra].
  change (c2 x * c2 x) with ((c2 x)²). rewrite sqrt_Rsqr_abs. unfold Rabs; destruct (Rcase_abs (c2 x)); lra. Qed.
Lemma eval_continuous x T p : solves f x T -> forall t, 0 <= t <= T -> continuity_pt (fun t => eval (x t) p) t.
Proof. intros so t ht. apply derivable_continuous_pt. eexists; eapply rate_derives; eauto. Qed.
Lemma nearest_continuous x T : solves f x T -> forall t, 0 <= t <= T -> continuity_pt (fun t => nearest (x t)) t.
Proof.
  intros so t ht. assert (k := fun p => eval_continuous x T p so t ht). unfold nearest, lin, c1, c2.
  set (A := fun t => eval (x t) (norm_poly n)). set (B := fun t => eval (x t) (paired variable n)).
  set (C := fun t => eval (x t) across). set (D := fun t => eval (x t) (paired X2 n)).
  assert (const : forall b : R, continuity_pt (fun _ => b) t) by (intros b; apply continuity_pt_const; intros ? ?; auto).
  apply (continuity_pt_minus (fun t => A t + norm (fun i => Q2R (z i)) n)
    (fun t => 2 * (B t + D t + sqrt (C t * C t + D t * D t)))).
  - apply (continuity_pt_plus A (fun _ => norm (fun i => Q2R (z i)) n)); [apply k | apply const].
  - apply (continuity_pt_mult (fun _ => 2) (fun t => B t + D t + sqrt (C t * C t + D t * D t))); [apply const|].
    apply (continuity_pt_plus (fun t => B t + D t) (fun t => sqrt (C t * C t + D t * D t))).
    + apply (continuity_pt_plus B D); apply k.
    + apply (continuity_pt_comp (fun t => C t * C t + D t * D t) sqrt).
      * apply (continuity_pt_plus (fun t => C t * C t) (fun t => D t * D t));
          [apply (continuity_pt_mult C C) | apply (continuity_pt_mult D D)]; apply k.
      * apply continuity_pt_sqrt. assert (q1 := Rle_0_sqr (C t)). assert (q2 := Rle_0_sqr (D t)). unfold Rsqr in *. lra. Qed.

Definition stable_up_to_turns : Prop := forall eps, 0 < eps -> exists del, 0 < del /\ forall x T, solves f x T ->
  (forall t, 0 <= t <= T -> inside (x t)) -> off (x 0) < del ->
  forall t, 0 <= t <= T -> exists a, off (turn a (x t)) < eps.

Theorem confined_up_to_turns g c l m s :
  let w := shift z across in check_extremum g (scale c (times w w)) l m s = true ->
  is_zero (rate f g) = true -> is_zero (rate X1 g) = true -> stable_up_to_turns.
Proof.
  intros w checked cons inv eps pe. set (extra := scale c (times w w)) in *.
  assert (flat : forall y, c1 y = 0 -> eval (fun i => y i - Q2R (z i)) extra = 0).
  { intros y h. unfold extra, w. rewrite eval_scale, eval_times, !eval_back. fold (c1 y). rewrite h; ring. }
  destruct (constants g extra l m s checked) as (pr & pm & pM).
  set (radius := radius s) in *. set (least := least g extra l m s) in *. set (most := most g extra) in *.
  set (e := Rmin eps radius). assert (pe' : 0 < e) by (unfold e; apply Rmin_glb_lt; auto).
  assert (e1 : e <= eps) by apply Rmin_l. assert (e2 : e <= radius) by apply Rmin_r.
  set (d := Rmin e (least * e / most)).
  assert (q0 : 0 < least * e / most) by (apply Rdiv_lt_0_compat; auto; apply Rmult_lt_0_compat; auto).
  assert (pd : 0 < d) by (unfold d; apply Rmin_glb_lt; auto).
  assert (d1 : d <= e) by apply Rmin_l. assert (d2 : d <= least * e / most) by apply Rmin_r.
  exists d; split; auto. intros x T so ins h0 t ht.
  assert (n0 := nearest_least (x 0)).
  assert (pinched : forall r, 0 <= r <= T -> nearest (x r) <= radius ->
    least * nearest (x r) <= eval (x r) g - Q2R (level g) <= most * nearest (x r)).
  { intros r hr near. destruct (best (x r)) as (a & pa & ea & sa).
    assert (p := pinch g extra l m s checked (turn a (x r)) (turn_inside _ a (ins r hr))
      ltac:(rewrite ea; exact near) (flat _ sa)).
    fold least most in p. rewrite ea, (turn_keeps (x r) g a pa inv) in p. exact p. }
  destruct (Rlt_le_dec (nearest (x t)) e) as [k|k].
  { destruct (best (x t)) as (a & _ & ea & _). exists a. rewrite ea. lra. }
  exfalso. assert (nt : 0 < t) by (destruct (Req_dec t 0) as [->|]; lra).
  assert (Y : exists c, 0 <= c <= T /\ nearest (x c) = e).
  { destruct k as [k|k]; [|exists t; split; auto; lra].
    destruct (IVT_interv (fun s => nearest (x s) - e) 0 t) as (q & hq & eq); try lra.
    - intros a ha. apply (continuity_pt_minus (fun s => nearest (x s)) (fun _ => e));
        [apply (nearest_continuous x T so); lra | apply continuity_pt_const; intros ? ?; reflexivity].
    - exists q; split; lra. }
  destruct Y as (q & hq & eq). assert (a := pinched q hq ltac:(lra)). assert (b := pinched 0 ltac:(lra) ltac:(lra)).
  rewrite (conserved f x T g so cons q hq), eq in a.
  assert (most * nearest (x 0) <= most * off (x 0)) by (apply Rmult_le_compat_l; lra).
  assert (most * off (x 0) < least * e); [|lra].
  apply Rlt_le_trans with (most * (least * e / most)); [apply Rmult_lt_compat_l; lra | right; field; lra]. Qed.
End Symmetry.
End Verdicts.

(* ---------------------------------------------------------------- from functions x1, ..., xn to the above and back *)

Definition path (l : list (R -> R)) (t : R) (i : nat) : R := nth i l (fun _ => 0) t.
Lemma path_beyond l t i : (length l <= i)%nat -> path l t i = 0.
Proof. intros h; unfold path; rewrite nth_overflow; auto. Qed.
Lemma path_inside n l z t : length l = n -> (length z <= n)%nat -> inside n (entry_of z) (path l t).
Proof. intros h k i hi. rewrite path_beyond by lia. unfold entry_of; rewrite nth_overflow by lia. rewrite Q2R_0; auto. Qed.
Lemma still_beyond f l t i : (length l <= i)%nat -> (length f <= i)%nat ->
  derivable_pt_lim (fun t => path l t i) t (eval (path l t) (equation f i)).
Proof.
  intros h k. unfold equation; rewrite nth_overflow by lia. simpl.
  unfold path; rewrite nth_overflow by lia. apply derivable_pt_lim_const. Qed.

(* proves that data and formulas are the same numbers *)
Ltac read_data := cbn [equation entry_of nth eval eval_mono off norm path]; unfold Q2R; cbn [Qnum Qden]; field.
