speedUp :: Velocity -> Velocity
speedUp (Velocity l a) =
  let faster = l * 1.1
      limit = 0.5
      capped = min limit faster
  in Velocity capped a

main :: IO ()
main = simulate speedUp
