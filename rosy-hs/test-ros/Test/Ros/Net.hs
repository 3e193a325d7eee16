{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : XML-RPC, HTTP and TCPROS as bytes.
module Test.Ros.Net (tests) where

import qualified Data.ByteString as B
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import Data.Either (isLeft)
import Ros.Net.Http
import Ros.Net.Rpc (Uri (..), readUri)
import Ros.Net.Slave
import Ros.Net.Tcpros
import Ros.Net.XmlRpc
import Test.Tasty
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck

tests :: TestTree
tests = testGroup "net" [xmlRpc, http, tcpros, slave, uris]

xmlRpc :: TestTree
xmlRpc =
  testGroup
    "XML-RPC"
    [ testProperty "a call comes back as it went" $
        forAll values $ \vs ->
          decodeCall (bytes (encodeCall (Call "m" vs))) === Right (Call "m" vs),
      testProperty "an answer comes back as it went" $
        forAll value $ \v ->
          decodeAnswer (bytes (encodeAnswer (Answer v))) === Right (Answer v),
      testProperty "cut anywhere before its end, an answer is refused and not misread" $ \n ->
        let whole = bytes (encodeAnswer (Answer (VArray [VInt 1, VString "x", VArray [VString "a"]])))
         in isLeft (decodeAnswer (B.take (n `mod` (B.length whole - B.length "</data></array></value></param></params></methodResponse>" - 1)) whole)),
      testProperty "any bytes are read or refused" $ \text ->
        either (const True) (const True) (decodeCall (C.pack text)),
      testCase "white space, i4, bare strings, empty values and character references are understood" $
        decodeAnswer
          "<?xml version='1.0'?>\n<methodResponse>\n<params>\n<param>\n<value><array><data>\n<value><i4>1</i4></value>\n<value>bare &lt;text&gt;&#33;</value> <value/><value></value>\
          \<value><double>1.</double></value><value><boolean>1</boolean></value>\n<value><struct><member><name>k</name>\n<value><int> -3 </int></value></member></struct></value>\
          \<!-- nothing --><value><string><![CDATA[a<b]]></string></value>\n</data></array></value>\n</param>\n</params>\n</methodResponse>\n"
          @?= Right (Answer (VArray [VInt 1, VString "bare <text>!", VString "", VString "", VDouble 1, VBool True, VStruct [("k", VInt (-3))], VString "a<b"])),
      testCase "a fault says why" $
        decodeAnswer "<methodResponse><fault><value><struct><member><name>faultCode</name><value><int>1</int></value></member><member><name>faultString</name><value><string>no</string></value></member></struct></value></fault></methodResponse>"
          @?= Right (Fault "no"),
      testCase "a call without parameters may leave them out" $
        decodeCall "<methodCall><methodName>getPid</methodName></methodCall>" @?= Right (Call "getPid" [])
    ]

http :: TestTree
http =
  testGroup
    "HTTP"
    [ testProperty "a request is whole when its last byte is there, wherever it was cut" $ \body n ->
        let whole = L.toStrict (post "h:1" "/RPC2" (Builder.byteString (C.pack body)))
            cut = n `mod` B.length whole
         in case (parseMessage (B.take cut whole), parseMessage (whole <> "next")) of
              (More _, Whole _ b rest) -> (b, rest) === (C.pack body, "next")
              other -> counterexample (show other) False,
      testCase "chunks are put together" $
        case parseMessage "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n3\r\nabc\r\nA;x\r\n0123456789\r\n0\r\n\r\n" of
          Whole _ b rest -> (b, rest) @?= ("abc0123456789", "")
          other -> assertFailure (show other),
      testCase "a response without a length ends with its connection" $
        fmap snd (bodyAtEnd "HTTP/1.0 200 OK\n\nall of it") @?= Just "all of it",
      testCase "an old client is not kept waiting for the end" $ do
        keepsAlive (Head "POST / HTTP/1.0" []) @?= False
        keepsAlive (Head "POST / HTTP/1.1" []) @?= True
        keepsAlive (Head "POST / HTTP/1.1" [("connection", "Close")]) @?= False,
      testCase "a head without end and a body without measure are refused" $ do
        parseMessage (C.replicate (maxHead + 1) 'x') @?= Bad "the head is too long"
        parseMessage "POST / HTTP/1.1\r\nContent-Length: 99999999999\r\n\r\n" @?= Bad "the body is too long"
    ]

tcpros :: TestTree
tcpros =
  testGroup
    "TCPROS"
    [ testProperty "any cuts give the same pieces" $ \pieces cuts ->
        let sent = map C.pack pieces
            stream = B.concat (map (frame . Builder.byteString) sent)
         in fed (cutAt cuts stream) === Right sent,
      testCase "a length beyond the limit is refused at once" $
        either (\(TooLong n) -> n) (const 0) (feed 100 noBytes (B.pack [101, 0, 0, 0])) @?= 101,
      testProperty "header fields come back as they went" $ \vs ->
        let fields = zip (map (("k" ++) . show) [1 :: Int ..]) (map (filter (\c -> c < '\xd800' || c > '\xdfff')) vs)
         in decodeFields (bytes (encodeFields fields)) === Right fields,
      testCase "a header is written as roscpp reads it" $
        bytes (encodeFields [("topic", "/x"), ("md5sum", "*")]) @?= "\8\0\0\0topic=/x\8\0\0\0md5sum=*",
      testCase "a star agrees with everything, another sum does not" $ do
        publisherAccepts offer [("callerid", "/a"), ("md5sum", "*")] @?= Right ()
        publisherAccepts offer [("callerid", "/a"), ("md5sum", "abc"), ("type", "q/R")] @?= Left (TypeClash ("q/R", "abc") ("p/T", "123"))
        publisherAccepts offer [("md5sum", "*")] @?= Left (MissingField "callerid"),
      testCase "a publisher that refuses or says too little is not listened to" $ do
        subscriberAccepts offer [("error", "no such topic")] @?= Left (TheyRefuse "no such topic")
        subscriberAccepts offer [("md5sum", "123")] @?= Left (MissingField "type")
        subscriberAccepts offer [("md5sum", "123"), ("type", "p/T")] @?= Right ()
    ]
  where
    offer = Offer "/me" "/t" "p/T" "123" ""
    fed = go noBytes []
      where
        go _ seen [] = Right (concat (reverse seen))
        go s seen (b : bs) = either (const (Left ())) (\(ps, s') -> go s' (ps : seen) bs) (feed maxFrame s b)
    cutAt cuts b = case cuts of
      [] -> [b]
      c : cs | B.null b -> [] | otherwise -> let (x, y) = B.splitAt (c `mod` (B.length b + 1)) b in x : cutAt cs y

slave :: TestTree
slave =
  testGroup
    "a node answers"
    [ testCase "requestTopic with its host and port" $
        ask "requestTopic" [VString "/out", VArray [VArray [VString "UDPROS"], VArray [VString "TCPROS"]]]
          @?= (Answer (VArray [VInt 1, VString "ready on here:99", VArray [VString "TCPROS", VString "here", VInt 99]]), []),
      testCase "requestTopic for a topic it does not publish with a refusal" $
        fst (ask "requestTopic" [VString "/in", VArray [VArray [VString "TCPROS"]]])
          @?= Answer (VArray [VInt (-1), VString "/in is not published here", VInt 0]),
      testCase "publisherUpdate at once, and connects after" $
        ask "publisherUpdate" [VString "/in", VArray [VString "http://a:1/", VString "http://b:2"]]
          @?= (Answer (VArray [VInt 1, VString "", VInt 0]), [PublishersAre "/in" [Uri "a" 1, Uri "b" 2]]),
      testCase "shutdown with the reason kept" $
        snd (ask "shutdown" [VString "new node"]) @?= [EndBecause "new node"],
      testCase "wrong arguments and unknown methods without dying" $ do
        fst (ask "publisherUpdate" [VInt 3]) @?= Answer (VArray [VInt (-1), VString "publisherUpdate: these are not its arguments", VInt 0])
        fst (ask "dance" []) @?= Fault "method \"dance\" is not supported",
      testCase "getBusInfo with every connection" $
        fst (ask "getBusInfo" [])
          @?= Answer (VArray [VInt 1, VString "", VArray [VArray [VInt 4, VString "/peer", VString "o", VString "TCPROS", VString "/out", VBool True]]])
    ]
  where
    ask m args = answerCall node (Call m (VString "/caller" : args))
    node = Slave 1 (Uri "m" 11311) "here" 99 [("/out", "p/T")] [("/in", "p/T")] [Connection 4 "/peer" Outbound "/out" 2 20]

uris :: TestTree
uris =
  testCase "addresses are read with and without their trimmings" $
    map readUri ["http://h:1/", "http://h:1", "h:1", "h", "http://h/", "", "http://h:x", "h:99999"]
      @?= [Just (Uri "h" 1), Just (Uri "h" 1), Just (Uri "h" 1), Just (Uri "h" 11311), Just (Uri "h" 11311), Nothing, Nothing, Nothing]

bytes :: Builder.Builder -> B.ByteString
bytes = L.toStrict . Builder.toLazyByteString

values :: Gen [Value]
values = resize 12 (listOf value)

value :: Gen Value
value = sized $ \n ->
  oneof $
    [ VInt <$> arbitrary,
      VBool <$> arbitrary,
      VDouble <$> arbitrary,
      VString <$> string
    ]
      ++ [VArray <$> resize (n `div` 3) (listOf value) | n > 0]
      ++ [VStruct <$> resize (n `div` 3) (listOf ((,) <$> string <*> value)) | n > 0]
  where
    -- XML knows no control characters and no half surrogates, and reads a carriage return as a new line.
    string = listOf (elements (['a' .. 'f'] ++ "<>&\"' \n/\228\8364\128512"))
