-- |
-- Module      : Rosy.Program
-- Description : What is added to a learner's program before it is compiled.
--
-- A program is written without a header, without instances and without @deriving@. The compiler of it (the worker, a build)
-- adds the following to the parsed tree, never to the text, so that every place in a message is the learner's own.
--
-- [Imports] @import Rosy@, hiding the names that the program itself defines at top level; the Prelude likewise, unless the program
--   imports it itself, and then also @import qualified Prelude@ for what is hidden; and @import qualified Rosy.Program@,
--   whose exports are all that the additions below need.
--
-- [Instances] For each @data@ or @newtype@ declaration @T a b@ with Haskell 98 constructors, also in GADT syntax (no
--   refined results, no existential variables):
--
--   > instance (Value a, Value b) => Value   (T a b) where …
--   > instance (Value a, Value b) => Default (T a b)
--   > instance (Value a, Value b) => Sensor  (T a b)
--   > instance (Value a, Value b) => Command (T a b)
--
--   All instances but that of 'Value' are empty. It says what the constructors are, here of @data T a b = Go | Turn { by :: a, at :: b }@:
--
--   > parts x = case x of { Go -> Parts "Go" [] []; Turn a1 a2 -> Parts "Turn" ["by", "at"] [Field a1, Field a2] }
--   > display = displayParts
--   > settle = settleParts
--   > initial = initialFrom [construct Go, withField (withField (construct Turn))]
--
--   A constructor between its fields, @Int :+ a@, is @InfixParts 9 ":+" (Field a1) (Field a2)@ with its precedence. GHC compiles this in a third
--   of the time of a 'GHC.Generics.Generic' instance. A type variable that is applied to something in a field (@f@ in @T (f Int)@) has the context
--   @Typeable f@ in place of @Value f@. For any other declaration, also with a field that has type variables of its own, leave out the second, give 'Value' the methods
--   'displayOpaque', 'settleOpaque' and 'initialOpaque', and put @Typeable a@ for every variable into the context.
--   Needs @StandaloneDeriving@, @FlexibleContexts@ and @UndecidableInstances@ (on 9.0, for the derived contexts).
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
-- [Topics] The right-hand side of @main@ becomes @withTopics ts@ of it, where @ts@ lists the topics of the program's own instances of 'Sensor' and
--   'Command', so that the link is told of them before the program runs (rule R23):
--
--   > main = withTopics [sensorTopics (sensor :: Sense Charge), commandTopics (command :: Plan Buzz)] (simulate …)
--
-- [Types of commands] In an instance of 'Command' that the program writes itself, the right-hand side of 'command' becomes @typeNamed "Buzz"@ of it, so that
--   the provenance of a firing tells the type of a command on a topic; the parameters of a type are left out:
--
--   > command = typeNamed "Buzz" (publish …)
--
-- [Whose task it is] Once the types are known, every expression of type @Task a@ in a definition @d@ becomes @within "d"@ of a function that gives it, so that a
--   loop of tasks that never lets time pass is blamed on the definition in which it stands.
module Rosy.Program
  ( -- * Instances
    Value (..),
    Default (..),
    Sensor (..),
    Command (..),
    Typeable,

    -- * Structure of values
    Parts (..),
    Field (..),
    displayParts,
    settleParts,
    initialFrom,
    construct,
    withField,

    -- * Values without a known structure
    displayOpaque,
    settleOpaque,
    initialOpaque,

    -- * Names
    Names (..),
    simulateNamed,
    taskNamed,
    taskWithNamed,
    onceNamed,
    callNamed,
    within,

    -- * Topics
    withTopics,
    Sense,
    Plan,
    sensorTopics,
    commandTopics,
    typeNamed,
  )
where

import Data.Typeable (Typeable)
import Rosy.Command (Command (..))
import Rosy.Controller (Names (..))
import Rosy.Core (Plan, Sense)
import Rosy.Launch (simulateNamed, withTopics)
import Rosy.Sensor (Sensor (..))
import Rosy.Task (callNamed, onceNamed, taskNamed, taskWithNamed, within)
import Rosy.Topic (commandTopics, sensorTopics, typeNamed)
import Rosy.Value (Default (..), Field (..), Parts (..), Pending, Value (..), construct, displayParts, initialFrom, settleParts, withField)

-- | Shows a value whose parts are not known as @_@.
displayOpaque :: Int -> a -> ShowS
displayOpaque _ x = x `seq` showString "_"

-- | Finishes a value as far as its constructor.
settleOpaque :: Int -> a -> Int
settleOpaque budget x = x `seq` budget - 1

-- | No default.
initialOpaque :: Pending -> Maybe a
initialOpaque _ = Nothing
