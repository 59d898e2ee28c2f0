"""Pictures of body plans with known truth: hulls by formula, drawn, then spoilt as a scanner or a camera would."""
