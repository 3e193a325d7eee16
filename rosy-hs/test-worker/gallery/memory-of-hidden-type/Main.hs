data Shown = forall a. Show a => Shown a

main = simulate (put, get)

put :: Bumper -> Memory Shown
put b = Memory (Shown b)

get :: Memory Shown -> Say
get (Memory (Shown x)) = Say (show x)
