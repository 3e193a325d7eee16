both :: Task ((), ())
both = parallel lights sounds

lights :: Task ()
lights = replicateM_ 3 (do { once (Led1 Red); wait 1; once (Led1 Black); wait 1 })

sounds :: Task ()
sounds = do { once OnSound; wait 2; once OffSound }

main :: IO ()
main = simulate (race both (wait 10))
