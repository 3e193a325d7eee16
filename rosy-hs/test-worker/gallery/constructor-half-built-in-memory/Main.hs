data Mode = Go | Turn Double Seconds
next :: Bumper -> Memory Mode
next _ = Memory (Turn 1.5)
main = simulate next
