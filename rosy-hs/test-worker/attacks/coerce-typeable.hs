import Data.Typeable.Internal

main = simulate (Say "HARM")
