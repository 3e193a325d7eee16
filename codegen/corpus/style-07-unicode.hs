-- Names from everywhere.
größe, ширина, 高さ :: Double
größe = 1
ширина = 2
高さ = 3

data Ёлка = Ёлка { висота :: Double } | Ωmega | Ünï

élan' :: Ёлка -> Double
élan' Ёлка {висота = h} = h * größe
élan' Ωmega = ширина + 高さ
élan' Ünï = α + β₁ where
  α = 0.5
  β₁ = 0.25

naïve :: Double -> Double
naïve x₁ = x₁ * 2

ünder_score, _unused, __, a' , a'' , a'b :: Double
ünder_score = naïve 1
_unused = 0
__ = 1
a' = 2
a'' = 3
a'b = 4

grüße :: String -> String
grüße wen = "Grüße, " ++ wen ++ "! ¡Olé! 🤖🚗"

main = simulate (once (Say (grüße "Welt")))
