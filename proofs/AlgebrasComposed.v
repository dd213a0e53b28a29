(** * Algebras made of others, and a user's own

    Written by [export_tables.py] from [polhode.algebra]; a test compares the two.  [_brackets] are the structure
    constants in the basis of the class, [_casimir1] and so on its named Casimirs, where these are polynomials. *)
From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect.
From Polhode Require Import Tables.
Local Open Scope Z_scope.

(** ** DualNumbers: DualNumbers(SU(2)), dimension 6 *)

Definition dual_numbers_su_2_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 1, -1); (0, 4, 5, 1); (0, 5, 4, -1); (1, 0, 2, -1); (1, 2, 0, 1); (1, 3, 5, -1);
  (1, 5, 3, 1); (2, 0, 1, 1); (2, 1, 0, -1); (2, 3, 4, 1); (2, 4, 3, -1); (3, 1, 5, 1); (3, 2, 4, -1);
  (4, 0, 5, -1); (4, 2, 3, 1); (5, 0, 4, 1); (5, 1, 3, -1)].

Definition dual_numbers_su_2 := dense 6 dual_numbers_su_2_brackets.

Theorem dual_numbers_su_2_is_lie : lie_algebra 6 dual_numbers_su_2.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* tr (iμ)^2, up to a factor *)
Definition dual_numbers_su_2_casimir1 : written_polynomial := [::
  ([:: 3; 3], 1); ([:: 4; 4], 1); ([:: 5; 5], 1)].

Theorem dual_numbers_su_2_casimir1_commutes : casimir 6 dual_numbers_su_2 dual_numbers_su_2_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* d tr (iμ)^2 *)
Definition dual_numbers_su_2_casimir2 : written_polynomial := [::
  ([:: 0; 3], 1); ([:: 1; 4], 1); ([:: 2; 5], 1)].

Theorem dual_numbers_su_2_casimir2_commutes : casimir 6 dual_numbers_su_2 dual_numbers_su_2_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** Power: SO3^3, dimension 9 *)

Definition power_of_so3_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 1, -1); (1, 0, 2, -1); (1, 2, 0, 1); (2, 0, 1, 1); (2, 1, 0, -1); (3, 4, 5, 1);
  (3, 5, 4, -1); (4, 3, 5, -1); (4, 5, 3, 1); (5, 3, 4, 1); (5, 4, 3, -1); (6, 7, 8, 1); (6, 8, 7, -1);
  (7, 6, 8, -1); (7, 8, 6, 1); (8, 6, 7, 1); (8, 7, 6, -1)].

Definition power_of_so3 := dense 9 power_of_so3_brackets.

Theorem power_of_so3_is_lie : lie_algebra 9 power_of_so3.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* |L|² of 0 *)
Definition power_of_so3_casimir1 : written_polynomial := [::
  ([:: 0; 0], 1); ([:: 1; 1], 1); ([:: 2; 2], 1)].

Theorem power_of_so3_casimir1_commutes : casimir 9 power_of_so3 power_of_so3_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* |L|² of 1 *)
Definition power_of_so3_casimir2 : written_polynomial := [::
  ([:: 3; 3], 1); ([:: 4; 4], 1); ([:: 5; 5], 1)].

Theorem power_of_so3_casimir2_commutes : casimir 9 power_of_so3 power_of_so3_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(* |L|² of 2 *)
Definition power_of_so3_casimir3 : written_polynomial := [::
  ([:: 6; 6], 1); ([:: 7; 7], 1); ([:: 8; 8], 1)].

Theorem power_of_so3_casimir3_commutes : casimir 9 power_of_so3 power_of_so3_casimir3.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** Power: SO3^3, dimension 9 *)

Definition weighted_power_of_so3_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 1, -1); (1, 0, 2, -1); (1, 2, 0, 1); (2, 0, 1, 1); (2, 1, 0, -1); (3, 4, 5, 1);
  (3, 5, 4, -1); (4, 3, 5, -1); (4, 5, 3, 1); (5, 3, 4, 1); (5, 4, 3, -1); (6, 7, 8, 1); (6, 8, 7, -1);
  (7, 6, 8, -1); (7, 8, 6, 1); (8, 6, 7, 1); (8, 7, 6, -1)].

Definition weighted_power_of_so3 := dense 9 weighted_power_of_so3_brackets.

Theorem weighted_power_of_so3_is_lie : lie_algebra 9 weighted_power_of_so3.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* |L|² of 0 *)
Definition weighted_power_of_so3_casimir1 : written_polynomial := [::
  ([:: 0; 0], 1); ([:: 1; 1], 1); ([:: 2; 2], 1)].

Theorem weighted_power_of_so3_casimir1_commutes : casimir 9 weighted_power_of_so3 weighted_power_of_so3_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* |L|² of 1, up to a factor *)
Definition weighted_power_of_so3_casimir2 : written_polynomial := [::
  ([:: 3; 3], 1); ([:: 4; 4], 1); ([:: 5; 5], 1)].

Theorem weighted_power_of_so3_casimir2_commutes : casimir 9 weighted_power_of_so3 weighted_power_of_so3_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(* |L|² of 2 *)
Definition weighted_power_of_so3_casimir3 : written_polynomial := [::
  ([:: 6; 6], 4); ([:: 7; 7], 4); ([:: 8; 8], 4)].

Theorem weighted_power_of_so3_casimir3_commutes : casimir 9 weighted_power_of_so3 weighted_power_of_so3_casimir3.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** Product: SO3 ⊕ SU(2) ⊕ AffineLine, dimension 8 *)

Definition product_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 1, -1); (1, 0, 2, -1); (1, 2, 0, 1); (2, 0, 1, 1); (2, 1, 0, -1); (3, 4, 5, 1);
  (3, 5, 4, -1); (4, 3, 5, -1); (4, 5, 3, 1); (5, 3, 4, 1); (5, 4, 3, -1); (6, 7, 7, 1); (7, 6, 7, -1)].

Definition product := dense 8 product_brackets.

Theorem product_is_lie : lie_algebra 8 product.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* |L|² of 0 *)
Definition product_casimir1 : written_polynomial := [::
  ([:: 0; 0], 1); ([:: 1; 1], 1); ([:: 2; 2], 1)].

Theorem product_casimir1_commutes : casimir 8 product product_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* tr (iμ)^2 of 1, up to a factor *)
Definition product_casimir2 : written_polynomial := [::
  ([:: 3; 3], 1); ([:: 4; 4], 1); ([:: 5; 5], 1)].

Theorem product_casimir2_commutes : casimir 8 product product_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** Semidirect: SO3 ⋉ R^3, dimension 6 *)

Definition so3_on_space_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 1, -1); (0, 4, 5, 1); (0, 5, 4, -1); (1, 0, 2, -1); (1, 2, 0, 1); (1, 3, 5, -1);
  (1, 5, 3, 1); (2, 0, 1, 1); (2, 1, 0, -1); (2, 3, 4, 1); (2, 4, 3, -1); (3, 1, 5, 1); (3, 2, 4, -1);
  (4, 0, 5, -1); (4, 2, 3, 1); (5, 0, 4, 1); (5, 1, 3, -1)].

Definition so3_on_space := dense 6 so3_on_space_brackets.

Theorem so3_on_space_is_lie : lie_algebra 6 so3_on_space.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* x1 x4 + x2 x5 + x3 x6 *)
Definition so3_on_space_casimir1 : written_polynomial := [::
  ([:: 0; 3], 1); ([:: 1; 4], 1); ([:: 2; 5], 1)].

Theorem so3_on_space_casimir1_commutes : casimir 6 so3_on_space so3_on_space_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* x4² + x5² + x6² *)
Definition so3_on_space_casimir2 : written_polynomial := [::
  ([:: 3; 3], 1); ([:: 4; 4], 1); ([:: 5; 5], 1)].

Theorem so3_on_space_casimir2_commutes : casimir 6 so3_on_space so3_on_space_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** Semidirect: SL(2) ⋉ R^2, dimension 5 *)

Definition sl2_on_plane_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 0, -2); (0, 4, 3, 1); (1, 0, 2, -1); (1, 2, 1, 2); (1, 3, 4, 1); (2, 0, 0, 2);
  (2, 1, 1, -2); (2, 3, 3, 1); (2, 4, 4, -1); (3, 1, 4, -1); (3, 2, 3, -1); (4, 0, 3, -1); (4, 2, 4, 1)].

Definition sl2_on_plane := dense 5 sl2_on_plane_brackets.

Theorem sl2_on_plane_is_lie : lie_algebra 5 sl2_on_plane.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* x1 x5² − x2 x4² + x3 x4 x5 *)
Definition sl2_on_plane_casimir1 : written_polynomial := [::
  ([:: 0; 4; 4], 1); ([:: 1; 3; 3], -1); ([:: 2; 3; 4], 1)].

Theorem sl2_on_plane_casimir1_commutes : casimir 5 sl2_on_plane sl2_on_plane_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** ConstantsAlgebra: ConstantsAlgebra, dimension 8 *)

Definition own_constants_brackets : brackets := [::
  (0, 2, 6, 2); (0, 3, 1, 2); (0, 4, 5, -2); (0, 6, 0, -4); (1, 2, 3, -2); (1, 4, 6, 1); (1, 4, 7, 1);
  (1, 5, 0, 2); (1, 6, 1, -2); (1, 7, 1, -6); (2, 0, 6, -2); (2, 1, 3, 2); (2, 5, 4, -2); (2, 6, 2, 4);
  (3, 0, 1, -2); (3, 4, 2, 2); (3, 5, 6, -1); (3, 5, 7, 1); (3, 6, 3, 2); (3, 7, 3, -6); (4, 0, 5, 2);
  (4, 1, 6, -1); (4, 1, 7, -1); (4, 3, 2, -2); (4, 6, 4, 2); (4, 7, 4, 6); (5, 1, 0, -2); (5, 2, 4, 2);
  (5, 3, 6, 1); (5, 3, 7, -1); (5, 6, 5, -2); (5, 7, 5, 6); (6, 0, 0, 4); (6, 1, 1, 2); (6, 2, 2, -4);
  (6, 3, 3, -2); (6, 4, 4, -2); (6, 5, 5, 2); (7, 1, 1, 6); (7, 3, 3, 6); (7, 4, 4, -6); (7, 5, 5, -6)].

Definition own_constants := dense 8 own_constants_brackets.

Theorem own_constants_is_lie : lie_algebra 8 own_constants.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* C1 *)
Definition own_constants_casimir1 : written_polynomial := [::
  ([:: 0; 2], 12); ([:: 1; 4], 12); ([:: 3; 5], 12); ([:: 6; 6], 3); ([:: 7; 7], 1)].

Theorem own_constants_casimir1_commutes : casimir 8 own_constants own_constants_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.

(* C2 *)
Definition own_constants_casimir2 : written_polynomial := [::
  ([:: 0; 2; 7], 36); ([:: 0; 3; 4], 108); ([:: 1; 2; 5], 108); ([:: 1; 4; 6], 54); ([:: 1; 4; 7], -18);
  ([:: 3; 5; 6], -54); ([:: 3; 5; 7], -18); ([:: 6; 6; 7], 9); ([:: 7; 7; 7], -1)].

Theorem own_constants_casimir2_commutes : casimir 8 own_constants own_constants_casimir2.
Proof. by apply: table_casimir; vm_compute. Qed.

(** ** MatrixBasisAlgebra: MatrixBasisAlgebra, dimension 3 *)

Definition own_matrices_brackets : brackets := [::
  (0, 1, 2, 1); (0, 2, 0, -2); (1, 0, 2, -1); (1, 2, 1, 2); (2, 0, 0, 2); (2, 1, 1, -2)].

Definition own_matrices := dense 3 own_matrices_brackets.

Theorem own_matrices_is_lie : lie_algebra 3 own_matrices.
Proof. by apply: table_is_lie; vm_compute. Qed.

(* 4 x1 x2 + x3² *)
Definition own_matrices_casimir1 : written_polynomial := [::
  ([:: 0; 1], 4); ([:: 2; 2], 1)].

Theorem own_matrices_casimir1_commutes : casimir 3 own_matrices own_matrices_casimir1.
Proof. by apply: table_casimir; vm_compute. Qed.
