-- |
-- Module      : Rosy.Program
-- Description : What is added to a learner's program before it is compiled.
--
-- A program is written without a header, without instances and without @deriving@. Whoever compiles it (the worker, a build)
-- adds the following to the parsed tree, never to the text, so that every place in a message is the learner's own.
--
-- [Imports] @import Rosy@, hiding the names that the program itself defines at top level; the Prelude likewise, unless the program
--   imports it itself, and then also @import qualified Prelude@ for what is hidden; and @import qualified Rosy.Program@,
--   whose exports are all that the additions below need.
--
-- [Instances] For each @data@ or @newtype@ declaration @T a b@ with Haskell 98 constructors (no GADT syntax with
--   refined results, no existential variables):
--
--   > deriving stock instance Generic (T a b)            -- unless the program derives Generic itself
--   > instance (Value a, Value b) => Value   (T a b)
--   > instance (Value a, Value b) => Default (T a b)
--   > instance (Value a, Value b) => Sensor  (T a b)
--   > instance (Value a, Value b) => Command (T a b)
--
--   All instances are empty. A type variable that is applied to something in a field (@f@ in @T (f Int)@) has the context
--   @Typeable f@ in place of @Value f@. For any other declaration leave out the first three and keep 'Sensor' and 'Command'.
--   Needs @StandaloneDeriving@, @DeriveGeneric@, @FlexibleContexts@ and @UndecidableInstances@ (on 9.0, for the derived contexts).
--   A field of a type without instances, such as a function, never makes this fail: it is shown as @_@.
--
-- [Names] A call of one of these functions becomes a call of its named form, with the names of the functions in the arguments:
--
--   > simulate c          simulateNamed n c
--   > task i c            taskNamed ni n i c
--   > taskWith o c        taskWithNamed ns nc n o c     -- names of starting, of stopped, of the controller
--   > once c              onceNamed n c
--   > call t o            callNamed n t o               -- Names [of cancelOn, of onFeedback, of onEnd]
--
--   The 'Names' of an expression: @Name "f"@ for a variable or an application of a variable @f …@; @Names [..]@ for a tuple or list
--   expression, one per element; the names of the body for parentheses and type signatures; @Names []@ for what has no name,
--   a lambda for instance. A variable that the program defines as a tuple or list without arguments has the names of its right-hand side.
--   Names are a service, not a duty: a tree of another shape than the controller falls back to @function 1@, @function 2@ …
--
-- [Whose task it is] Once the types are known, every expression of type @Task a@ in a definition @d@ becomes @within "d"@ of a function that gives it, so that a
--   loop of tasks that never lets time pass is blamed on the definition in which it stands.
module Rosy.Program
  ( -- * Instances
    Generic,
    Value (..),
    Default (..),
    Sensor (..),
    Command (..),
    Typeable,

    -- * Names
    Names (..),
    simulateNamed,
    taskNamed,
    taskWithNamed,
    onceNamed,
    callNamed,
    within,
  )
where

import Data.Typeable (Typeable)
import GHC.Generics (Generic)
import Rosy.Command (Command (..))
import Rosy.Controller (Names (..))
import Rosy.Launch (simulateNamed)
import Rosy.Sensor (Sensor (..))
import Rosy.Task (callNamed, onceNamed, taskNamed, taskWithNamed, within)
import Rosy.Value (Default (..), Value (..))
