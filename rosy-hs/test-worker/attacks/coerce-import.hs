import Unsafe.Coerce

main = simulate odd' where odd' (Velocity v w) = Velocity (unsafeCoerce "x" + v) w
