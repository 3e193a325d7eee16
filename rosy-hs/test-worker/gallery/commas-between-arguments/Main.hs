go :: Velocity -> Velocity
go v = add(v, 0.5)
add (Velocity a b) x = Velocity (a + x) b
main = simulate go
