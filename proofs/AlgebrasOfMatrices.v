(** * Algebras of matrices

    Written by [export_tables.py] from [polhode.algebra]; a test compares the two.  [_brackets] are the structure
    constants in the basis of the class, [_casimir1] and so on its named Casimirs, where these are polynomials. *)
From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect.
From Polhode Require Import Tables.
Local Open Scope Z_scope.

(** ** SO: SO(2), dimension 1 *)

Definition so_2_brackets : brackets := [::
  ].

Definition so_2 := dense 1 so_2_brackets.

Theorem so_2_is_lie : lie_algebra 1 so_2.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* Pf μ *)
Definition so_2_casimir1 : written_polynomial := [::
  ([:: 0], -1)].

Theorem so_2_casimir1_commutes : casimir 1 so_2 so_2_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** SO: SO(3), dimension 3 *)

Definition so_3_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 1, -1); (1, 0, 2, -1); (1, 2, 0, 1); (2, 0, 1, 1); (2, 1, 0, -1)].

Definition so_3 := dense 3 so_3_brackets.

Theorem so_3_is_lie : lie_algebra 3 so_3.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* −½ tr μ² *)
Definition so_3_casimir1 : written_polynomial := [::
  ([:: 0; 0], 1); ([:: 1; 1], 1); ([:: 2; 2], 1)].

Theorem so_3_casimir1_commutes : casimir 3 so_3 so_3_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** SO: SO(4), dimension 6 *)

Definition so_4_brackets : brackets := [::
  (0, 1, 3, 1); (0, 2, 4, 1); (0, 3, 1, -1); (0, 4, 2, -1); (1, 0, 3, -1); (1, 2, 5, 1); (1, 3, 0, 1);
  (1, 5, 2, -1); (2, 0, 4, -1); (2, 1, 5, -1); (2, 4, 0, 1); (2, 5, 1, 1); (3, 0, 1, 1); (3, 1, 0, -1);
  (3, 4, 5, 1); (3, 5, 4, -1); (4, 0, 2, 1); (4, 2, 0, -1); (4, 3, 5, -1); (4, 5, 3, 1); (5, 1, 2, 1);
  (5, 2, 1, -1); (5, 3, 4, 1); (5, 4, 3, -1)].

Definition so_4 := dense 6 so_4_brackets.

Theorem so_4_is_lie : lie_algebra 6 so_4.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* −½ tr μ² *)
Definition so_4_casimir1 : written_polynomial := [::
  ([:: 0; 0], 1); ([:: 1; 1], 1); ([:: 2; 2], 1); ([:: 3; 3], 1); ([:: 4; 4], 1); ([:: 5; 5], 1)].

Theorem so_4_casimir1_commutes : casimir 6 so_4 so_4_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* Pf μ *)
Definition so_4_casimir2 : written_polynomial := [::
  ([:: 0; 5], 1); ([:: 1; 4], -1); ([:: 2; 3], 1)].

Theorem so_4_casimir2_commutes : casimir 6 so_4 so_4_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** SO: SO(5), dimension 10 *)

Definition so_5_brackets : brackets := [::
  (0, 1, 4, 1); (0, 2, 5, 1); (0, 3, 6, 1); (0, 4, 1, -1); (0, 5, 2, -1); (0, 6, 3, -1); (1, 0, 4, -1);
  (1, 2, 7, 1); (1, 3, 8, 1); (1, 4, 0, 1); (1, 7, 2, -1); (1, 8, 3, -1); (2, 0, 5, -1); (2, 1, 7, -1);
  (2, 3, 9, 1); (2, 5, 0, 1); (2, 7, 1, 1); (2, 9, 3, -1); (3, 0, 6, -1); (3, 1, 8, -1); (3, 2, 9, -1);
  (3, 6, 0, 1); (3, 8, 1, 1); (3, 9, 2, 1); (4, 0, 1, 1); (4, 1, 0, -1); (4, 5, 7, 1); (4, 6, 8, 1);
  (4, 7, 5, -1); (4, 8, 6, -1); (5, 0, 2, 1); (5, 2, 0, -1); (5, 4, 7, -1); (5, 6, 9, 1); (5, 7, 4, 1);
  (5, 9, 6, -1); (6, 0, 3, 1); (6, 3, 0, -1); (6, 4, 8, -1); (6, 5, 9, -1); (6, 8, 4, 1); (6, 9, 5, 1);
  (7, 1, 2, 1); (7, 2, 1, -1); (7, 4, 5, 1); (7, 5, 4, -1); (7, 8, 9, 1); (7, 9, 8, -1); (8, 1, 3, 1);
  (8, 3, 1, -1); (8, 4, 6, 1); (8, 6, 4, -1); (8, 7, 9, -1); (8, 9, 7, 1); (9, 2, 3, 1); (9, 3, 2, -1);
  (9, 5, 6, 1); (9, 6, 5, -1); (9, 7, 8, 1); (9, 8, 7, -1)].

Definition so_5 := dense 10 so_5_brackets.

Theorem so_5_is_lie : lie_algebra 10 so_5.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* −½ tr μ² *)
Definition so_5_casimir1 : written_polynomial := [::
  ([:: 0; 0], 1); ([:: 1; 1], 1); ([:: 2; 2], 1); ([:: 3; 3], 1); ([:: 4; 4], 1); ([:: 5; 5], 1);
  ([:: 6; 6], 1); ([:: 7; 7], 1); ([:: 8; 8], 1); ([:: 9; 9], 1)].

Theorem so_5_casimir1_commutes : casimir 10 so_5 so_5_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* tr μ^4 *)
Definition so_5_casimir2 : written_polynomial := [::
  ([:: 0; 0; 0; 0], 2); ([:: 0; 0; 1; 1], 4); ([:: 0; 0; 2; 2], 4); ([:: 0; 0; 3; 3], 4);
  ([:: 0; 0; 4; 4], 4); ([:: 0; 0; 5; 5], 4); ([:: 0; 0; 6; 6], 4); ([:: 0; 1; 5; 7], 8);
  ([:: 0; 1; 6; 8], 8); ([:: 0; 2; 4; 7], -8); ([:: 0; 2; 6; 9], 8); ([:: 0; 3; 4; 8], -8);
  ([:: 0; 3; 5; 9], -8); ([:: 1; 1; 1; 1], 2); ([:: 1; 1; 2; 2], 4); ([:: 1; 1; 3; 3], 4);
  ([:: 1; 1; 4; 4], 4); ([:: 1; 1; 7; 7], 4); ([:: 1; 1; 8; 8], 4); ([:: 1; 2; 4; 5], 8);
  ([:: 1; 2; 8; 9], 8); ([:: 1; 3; 4; 6], 8); ([:: 1; 3; 7; 9], -8); ([:: 2; 2; 2; 2], 2);
  ([:: 2; 2; 3; 3], 4); ([:: 2; 2; 5; 5], 4); ([:: 2; 2; 7; 7], 4); ([:: 2; 2; 9; 9], 4);
  ([:: 2; 3; 5; 6], 8); ([:: 2; 3; 7; 8], 8); ([:: 3; 3; 3; 3], 2); ([:: 3; 3; 6; 6], 4);
  ([:: 3; 3; 8; 8], 4); ([:: 3; 3; 9; 9], 4); ([:: 4; 4; 4; 4], 2); ([:: 4; 4; 5; 5], 4);
  ([:: 4; 4; 6; 6], 4); ([:: 4; 4; 7; 7], 4); ([:: 4; 4; 8; 8], 4); ([:: 4; 5; 8; 9], 8);
  ([:: 4; 6; 7; 9], -8); ([:: 5; 5; 5; 5], 2); ([:: 5; 5; 6; 6], 4); ([:: 5; 5; 7; 7], 4);
  ([:: 5; 5; 9; 9], 4); ([:: 5; 6; 7; 8], 8); ([:: 6; 6; 6; 6], 2); ([:: 6; 6; 8; 8], 4);
  ([:: 6; 6; 9; 9], 4); ([:: 7; 7; 7; 7], 2); ([:: 7; 7; 8; 8], 4); ([:: 7; 7; 9; 9], 4);
  ([:: 8; 8; 8; 8], 2); ([:: 8; 8; 9; 9], 4); ([:: 9; 9; 9; 9], 2)].

Theorem so_5_casimir2_commutes : casimir 10 so_5 so_5_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** SOpq: SO(2,1), dimension 3 *)

Definition so_2_1_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 1, -1); (1, 0, 2, -1); (1, 2, 0, -1); (2, 0, 1, 1); (2, 1, 0, 1)].

Definition so_2_1 := dense 3 so_2_1_brackets.

Theorem so_2_1_is_lie : lie_algebra 3 so_2_1.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* −½ tr μ² *)
Definition so_2_1_casimir1 : written_polynomial := [::
  ([:: 0; 0], 1); ([:: 1; 1], -1); ([:: 2; 2], -1)].

Theorem so_2_1_casimir1_commutes : casimir 3 so_2_1 so_2_1_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** SOpq: SO(3,1), dimension 6 *)

Definition so_3_1_brackets : brackets := [::
  (0, 1, 3, 1); (0, 2, 4, 1); (0, 3, 1, -1); (0, 4, 2, -1); (1, 0, 3, -1); (1, 2, 5, 1); (1, 3, 0, 1);
  (1, 5, 2, -1); (2, 0, 4, -1); (2, 1, 5, -1); (2, 4, 0, -1); (2, 5, 1, -1); (3, 0, 1, 1); (3, 1, 0, -1);
  (3, 4, 5, 1); (3, 5, 4, -1); (4, 0, 2, 1); (4, 2, 0, 1); (4, 3, 5, -1); (4, 5, 3, -1); (5, 1, 2, 1);
  (5, 2, 1, 1); (5, 3, 4, 1); (5, 4, 3, 1)].

Definition so_3_1 := dense 6 so_3_1_brackets.

Theorem so_3_1_is_lie : lie_algebra 6 so_3_1.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* −½ tr μ² *)
Definition so_3_1_casimir1 : written_polynomial := [::
  ([:: 0; 0], 1); ([:: 1; 1], 1); ([:: 2; 2], -1); ([:: 3; 3], 1); ([:: 4; 4], -1); ([:: 5; 5], -1)].

Theorem so_3_1_casimir1_commutes : casimir 6 so_3_1 so_3_1_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* Pf ημ *)
Definition so_3_1_casimir2 : written_polynomial := [::
  ([:: 0; 5], -1); ([:: 1; 4], 1); ([:: 2; 3], -1)].

Theorem so_3_1_casimir2_commutes : casimir 6 so_3_1 so_3_1_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** SU: SU(2), dimension 3 *)

Definition su_2_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 1, -1); (1, 0, 2, -1); (1, 2, 0, 1); (2, 0, 1, 1); (2, 1, 0, -1)].

Definition su_2 := dense 3 su_2_brackets.

Theorem su_2_is_lie : lie_algebra 3 su_2.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* tr (iμ)^2, up to a factor *)
Definition su_2_casimir1 : written_polynomial := [::
  ([:: 0; 0], 1); ([:: 1; 1], 1); ([:: 2; 2], 1)].

Theorem su_2_casimir1_commutes : casimir 3 su_2 su_2_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** SU: SU(3), dimension 8 *)

Definition su_3_brackets : brackets := [::
  (0, 1, 2, 2); (0, 2, 1, -2); (0, 3, 6, 1); (0, 4, 5, -1); (0, 5, 4, 1); (0, 6, 3, -1); (1, 0, 2, -2);
  (1, 2, 0, 2); (1, 3, 5, 1); (1, 4, 6, 1); (1, 5, 3, -1); (1, 6, 4, -1); (2, 0, 1, 2); (2, 1, 0, -2);
  (2, 3, 4, 1); (2, 4, 3, -1); (2, 5, 6, -1); (2, 6, 5, 1); (3, 0, 6, -1); (3, 1, 5, -1); (3, 2, 4, -1);
  (3, 4, 2, 1); (3, 4, 7, 1); (3, 5, 1, 1); (3, 6, 0, 1); (3, 7, 4, -3); (4, 0, 5, 1); (4, 1, 6, -1);
  (4, 2, 3, 1); (4, 3, 2, -1); (4, 3, 7, -1); (4, 5, 0, -1); (4, 6, 1, 1); (4, 7, 3, 3); (5, 0, 4, -1);
  (5, 1, 3, 1); (5, 2, 6, 1); (5, 3, 1, -1); (5, 4, 0, 1); (5, 6, 2, -1); (5, 6, 7, 1); (5, 7, 6, -3);
  (6, 0, 3, 1); (6, 1, 4, 1); (6, 2, 5, -1); (6, 3, 0, -1); (6, 4, 1, -1); (6, 5, 2, 1); (6, 5, 7, -1);
  (6, 7, 5, 3); (7, 3, 4, 3); (7, 4, 3, -3); (7, 5, 6, 3); (7, 6, 5, -3)].

Definition su_3 := dense 8 su_3_brackets.

Theorem su_3_is_lie : lie_algebra 8 su_3.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* tr (iμ)^2, up to a factor *)
Definition su_3_casimir1 : written_polynomial := [::
  ([:: 0; 0], 3); ([:: 1; 1], 3); ([:: 2; 2], 3); ([:: 3; 3], 3); ([:: 4; 4], 3); ([:: 5; 5], 3);
  ([:: 6; 6], 3); ([:: 7; 7], 1)].

Theorem su_3_casimir1_commutes : casimir 8 su_3 su_3_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* tr (iμ)^3, up to a factor *)
Definition su_3_casimir2 : written_polynomial := [::
  ([:: 0; 0; 7], 18); ([:: 0; 3; 5], 54); ([:: 0; 4; 6], 54); ([:: 1; 1; 7], 18); ([:: 1; 3; 6], -54);
  ([:: 1; 4; 5], 54); ([:: 2; 2; 7], 18); ([:: 2; 3; 3], 27); ([:: 2; 4; 4], 27); ([:: 2; 5; 5], -27);
  ([:: 2; 6; 6], -27); ([:: 3; 3; 7], -9); ([:: 4; 4; 7], -9); ([:: 5; 5; 7], -9); ([:: 6; 6; 7], -9);
  ([:: 7; 7; 7], -2)].

Theorem su_3_casimir2_commutes : casimir 8 su_3 su_3_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** U: U(1), dimension 1 *)

Definition u_1_brackets : brackets := [::
  ].

Definition u_1 := dense 1 u_1_brackets.

Theorem u_1_is_lie : lie_algebra 1 u_1.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* tr iμ *)
Definition u_1_casimir1 : written_polynomial := [::
  ([:: 0], 1)].

Theorem u_1_casimir1_commutes : casimir 1 u_1 u_1_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** U: U(2), dimension 4 *)

Definition u_2_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 1, -1); (1, 0, 2, -1); (1, 2, 0, 1); (2, 0, 1, 1); (2, 1, 0, -1)].

Definition u_2 := dense 4 u_2_brackets.

Theorem u_2_is_lie : lie_algebra 4 u_2.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* tr iμ *)
Definition u_2_casimir1 : written_polynomial := [::
  ([:: 3], 1)].

Theorem u_2_casimir1_commutes : casimir 4 u_2 u_2_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* tr (iμ)^2, up to a factor *)
Definition u_2_casimir2 : written_polynomial := [::
  ([:: 0; 0], 1); ([:: 1; 1], 1); ([:: 2; 2], 1); ([:: 3; 3], 1)].

Theorem u_2_casimir2_commutes : casimir 4 u_2 u_2_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** SL: SL(2), dimension 3 *)

Definition sl_2_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 0, -2); (1, 0, 2, -1); (1, 2, 1, 2); (2, 0, 0, 2); (2, 1, 1, -2)].

Definition sl_2 := dense 3 sl_2_brackets.

Theorem sl_2_is_lie : lie_algebra 3 sl_2.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* tr μ^2, up to a factor *)
Definition sl_2_casimir1 : written_polynomial := [::
  ([:: 0; 1], 4); ([:: 2; 2], 1)].

Theorem sl_2_casimir1_commutes : casimir 3 sl_2 sl_2_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** SL: SL(3), dimension 8 *)

Definition sl_3_brackets : brackets := [::
  (0, 2, 6, 2); (0, 3, 1, 2); (0, 4, 5, -2); (0, 6, 0, -4); (1, 2, 3, -2); (1, 4, 6, 1); (1, 4, 7, 1);
  (1, 5, 0, 2); (1, 6, 1, -2); (1, 7, 1, -6); (2, 0, 6, -2); (2, 1, 3, 2); (2, 5, 4, -2); (2, 6, 2, 4);
  (3, 0, 1, -2); (3, 4, 2, 2); (3, 5, 6, -1); (3, 5, 7, 1); (3, 6, 3, 2); (3, 7, 3, -6); (4, 0, 5, 2);
  (4, 1, 6, -1); (4, 1, 7, -1); (4, 3, 2, -2); (4, 6, 4, 2); (4, 7, 4, 6); (5, 1, 0, -2); (5, 2, 4, 2);
  (5, 3, 6, 1); (5, 3, 7, -1); (5, 6, 5, -2); (5, 7, 5, 6); (6, 0, 0, 4); (6, 1, 1, 2); (6, 2, 2, -4);
  (6, 3, 3, -2); (6, 4, 4, -2); (6, 5, 5, 2); (7, 1, 1, 6); (7, 3, 3, 6); (7, 4, 4, -6); (7, 5, 5, -6)].

Definition sl_3 := dense 8 sl_3_brackets.

Theorem sl_3_is_lie : lie_algebra 8 sl_3.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* tr μ^2, up to a factor *)
Definition sl_3_casimir1 : written_polynomial := [::
  ([:: 0; 2], 12); ([:: 1; 4], 12); ([:: 3; 5], 12); ([:: 6; 6], 3); ([:: 7; 7], 1)].

Theorem sl_3_casimir1_commutes : casimir 8 sl_3 sl_3_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* tr μ^3, up to a factor *)
Definition sl_3_casimir2 : written_polynomial := [::
  ([:: 0; 2; 7], 36); ([:: 0; 3; 4], 108); ([:: 1; 2; 5], 108); ([:: 1; 4; 6], 54); ([:: 1; 4; 7], -18);
  ([:: 3; 5; 6], -54); ([:: 3; 5; 7], -18); ([:: 6; 6; 7], 9); ([:: 7; 7; 7], -1)].

Theorem sl_3_casimir2_commutes : casimir 8 sl_3 sl_3_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** Sp: Sp(1), dimension 3 *)

Definition sp_1_brackets : brackets := [::
  (0, 1, 1, 2); (0, 2, 2, -2); (1, 0, 1, -2); (1, 2, 0, 1); (2, 0, 2, 2); (2, 1, 0, -1)].

Definition sp_1 := dense 3 sp_1_brackets.

Theorem sp_1_is_lie : lie_algebra 3 sp_1.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* tr μ^2 *)
Definition sp_1_casimir1 : written_polynomial := [::
  ([:: 0; 0], 2); ([:: 1; 2], 8)].

Theorem sp_1_casimir1_commutes : casimir 3 sp_1 sp_1_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** Sp: Sp(2), dimension 10 *)

Definition sp_2_brackets : brackets := [::
  (0, 1, 1, 1); (0, 2, 2, -1); (0, 4, 4, 2); (0, 5, 5, 1); (0, 7, 7, -2); (0, 8, 8, -1); (1, 0, 1, -1);
  (1, 2, 0, 1); (1, 2, 3, -1); (1, 3, 1, 1); (1, 5, 4, 2); (1, 6, 5, 1); (1, 7, 8, -1); (1, 8, 9, -2);
  (2, 0, 2, 1); (2, 1, 0, -1); (2, 1, 3, 1); (2, 3, 2, -1); (2, 4, 5, 1); (2, 5, 6, 2); (2, 8, 7, -2);
  (2, 9, 8, -1); (3, 1, 1, -1); (3, 2, 2, 1); (3, 5, 5, 1); (3, 6, 6, 2); (3, 8, 8, -1); (3, 9, 9, -2);
  (4, 0, 4, -2); (4, 2, 5, -1); (4, 7, 0, 1); (4, 8, 1, 1); (5, 0, 5, -1); (5, 1, 4, -2); (5, 2, 6, -2);
  (5, 3, 5, -1); (5, 7, 2, 1); (5, 8, 0, 1); (5, 8, 3, 1); (5, 9, 1, 1); (6, 1, 5, -1); (6, 3, 6, -2);
  (6, 8, 2, 1); (6, 9, 3, 1); (7, 0, 7, 2); (7, 1, 8, 1); (7, 4, 0, -1); (7, 5, 2, -1); (8, 0, 8, 1);
  (8, 1, 9, 2); (8, 2, 7, 2); (8, 3, 8, 1); (8, 4, 1, -1); (8, 5, 0, -1); (8, 5, 3, -1); (8, 6, 2, -1);
  (9, 2, 8, 1); (9, 3, 9, 2); (9, 5, 1, -1); (9, 6, 3, -1)].

Definition sp_2 := dense 10 sp_2_brackets.

Theorem sp_2_is_lie : lie_algebra 10 sp_2.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* tr μ^2 *)
Definition sp_2_casimir1 : written_polynomial := [::
  ([:: 0; 0], 2); ([:: 1; 2], 4); ([:: 3; 3], 2); ([:: 4; 7], 8); ([:: 5; 8], 4); ([:: 6; 9], 8)].

Theorem sp_2_casimir1_commutes : casimir 10 sp_2 sp_2_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* tr μ^4 *)
Definition sp_2_casimir2 : written_polynomial := [::
  ([:: 0; 0; 0; 0], 2); ([:: 0; 0; 1; 2], 8); ([:: 0; 0; 4; 7], 16); ([:: 0; 0; 5; 8], 8);
  ([:: 0; 1; 2; 3], 8); ([:: 0; 1; 6; 8], 16); ([:: 0; 2; 5; 9], 16); ([:: 0; 3; 5; 8], -8);
  ([:: 1; 1; 2; 2], 4); ([:: 1; 1; 6; 7], -16); ([:: 1; 2; 3; 3], 8); ([:: 1; 2; 4; 7], 32);
  ([:: 1; 2; 5; 8], 8); ([:: 1; 2; 6; 9], 32); ([:: 1; 3; 5; 7], 16); ([:: 2; 2; 4; 9], -16);
  ([:: 2; 3; 4; 8], 16); ([:: 3; 3; 3; 3], 2); ([:: 3; 3; 5; 8], 8); ([:: 3; 3; 6; 9], 16);
  ([:: 4; 4; 7; 7], 32); ([:: 4; 5; 7; 8], 32); ([:: 4; 6; 8; 8], 16); ([:: 5; 5; 7; 9], 16);
  ([:: 5; 5; 8; 8], 4); ([:: 5; 6; 8; 9], 32); ([:: 6; 6; 9; 9], 32)].

Theorem sp_2_casimir2_commutes : casimir 10 sp_2 sp_2_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** QuantizedSphere: QuantizedSphere(2), dimension 3 *)

Definition sphere_2_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 1, -1); (1, 0, 2, -1); (1, 2, 0, 1); (2, 0, 1, 1); (2, 1, 0, -1)].

Definition sphere_2 := dense 3 sphere_2_brackets.

Theorem sphere_2_is_lie : lie_algebra 3 sphere_2.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* tr (−iμ)^2, up to a factor *)
Definition sphere_2_casimir1 : written_polynomial := [::
  ([:: 0; 0], 1); ([:: 1; 1], 1); ([:: 2; 2], 1)].

Theorem sphere_2_casimir1_commutes : casimir 3 sphere_2 sphere_2_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** QuantizedSphere: QuantizedSphere(3), dimension 8 *)

Definition sphere_3_brackets : brackets := [::
  (0, 1, 2, 2); (0, 2, 1, -2); (0, 4, 5, 2); (0, 5, 4, -2); (0, 6, 7, 4); (0, 7, 6, -4); (1, 0, 2, -2);
  (1, 2, 0, 2); (1, 3, 5, -2); (1, 4, 7, -1); (1, 5, 3, 6); (1, 5, 6, 1); (1, 6, 5, -4); (1, 7, 4, 4);
  (2, 0, 1, 2); (2, 1, 0, -2); (2, 3, 4, 2); (2, 4, 3, -6); (2, 4, 6, 1); (2, 5, 7, 1); (2, 6, 4, -4);
  (2, 7, 5, -4); (3, 1, 5, 2); (3, 2, 4, -2); (3, 4, 2, 18); (3, 5, 1, -18); (4, 0, 5, -2); (4, 1, 7, 1);
  (4, 2, 3, 6); (4, 2, 6, -1); (4, 3, 2, -18); (4, 5, 0, 18); (4, 6, 2, 36); (4, 7, 1, -36); (5, 0, 4, 2);
  (5, 1, 3, -6); (5, 1, 6, -1); (5, 2, 7, -1); (5, 3, 1, 18); (5, 4, 0, -18); (5, 6, 1, 36); (5, 7, 2, 36);
  (6, 0, 7, -4); (6, 1, 5, 4); (6, 2, 4, 4); (6, 4, 2, -36); (6, 5, 1, -36); (6, 7, 0, 144); (7, 0, 6, 4);
  (7, 1, 4, -4); (7, 2, 5, 4); (7, 4, 1, 36); (7, 5, 2, -36); (7, 6, 0, -144)].

Definition sphere_3 := dense 8 sphere_3_brackets.

Theorem sphere_3_is_lie : lie_algebra 8 sphere_3.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* tr (−iμ)^2, up to a factor *)
Definition sphere_3_casimir1 : written_polynomial := [::
  ([:: 0; 0], 36); ([:: 1; 1], 36); ([:: 2; 2], 36); ([:: 3; 3], 12); ([:: 4; 4], 4); ([:: 5; 5], 4);
  ([:: 6; 6], 1); ([:: 7; 7], 1)].

Theorem sphere_3_casimir1_commutes : casimir 8 sphere_3 sphere_3_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* tr (−iμ)^3, up to a factor *)
Definition sphere_3_casimir2 : written_polynomial := [::
  ([:: 0; 0; 3], 36); ([:: 0; 1; 4], 36); ([:: 0; 2; 5], 36); ([:: 1; 1; 3], -18); ([:: 1; 1; 6], 9);
  ([:: 1; 2; 7], 18); ([:: 2; 2; 3], -18); ([:: 2; 2; 6], -9); ([:: 3; 3; 3], -4); ([:: 3; 4; 4], -2);
  ([:: 3; 5; 5], -2); ([:: 3; 6; 6], 1); ([:: 3; 7; 7], 1); ([:: 4; 4; 6], -1); ([:: 4; 5; 7], -2);
  ([:: 5; 5; 6], 1)].

Theorem sphere_3_casimir2_commutes : casimir 8 sphere_3 sphere_3_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.
