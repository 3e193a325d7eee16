import Control.Exception
import Control.Monad (forever)

main = mask_ (forever (pure ()))
