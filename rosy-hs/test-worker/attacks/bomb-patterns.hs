main = simulate f

f :: Velocity -> Say
f _ = Say (g True True True True True True True True True True True True)

g :: Bool -> Bool -> Bool -> Bool -> Bool -> Bool -> Bool -> Bool -> Bool -> Bool -> Bool -> Bool -> String
g True _ _ _ _ _ _ _ _ _ _ _ = "x"
g _ True _ _ _ _ _ _ _ _ _ _ = "x"
g _ _ True _ _ _ _ _ _ _ _ _ = "x"
g _ _ _ True _ _ _ _ _ _ _ _ = "x"
g _ _ _ _ True _ _ _ _ _ _ _ = "x"
g _ _ _ _ _ True _ _ _ _ _ _ = "x"
g _ _ _ _ _ _ True _ _ _ _ _ = "x"
g _ _ _ _ _ _ _ True _ _ _ _ = "x"
g _ _ _ _ _ _ _ _ True _ _ _ = "x"
g _ _ _ _ _ _ _ _ _ True _ _ = "x"
g _ _ _ _ _ _ _ _ _ _ True _ = "x"
g _ _ _ _ _ _ _ _ _ _ _ True = "x"
