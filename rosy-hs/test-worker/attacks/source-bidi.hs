main = simulate (Velocity 0 0 {- ‮ )0 9 yticoleV( ⁦ -}) -- ‮⁦ nothing to see ⁩⁦
