/// Worksheets of the first eight lessons, an activity without a computer for each, and two written tests, in Spanish.

import type {WorksheetWords} from "../../en/page/worksheets.ts"

export const worksheets: WorksheetWords = {
  labels: {
    sheet: lesson => `Ficha: ${lesson}`,
    slides: course => `Diapositivas: ${course}`,
    name: "Nombre:",
    answer: "Tu respuesta:",
    forTeachers: "Para docentes: respuestas",
    unplugged: title => `Sin ordenador: ${title}`,
    test: number => `Prueba ${number}`,
    testLead:
      "20 minutos, en papel, sin ordenador. Un punto por pregunta. Marca una respuesta o escribe un número.",
    marking:
      "Escribe las respuestas en una tabla: un nombre, la prueba y las respuestas en orden, y guárdala como CSV. `./rosy class marks answers.csv -o marks.csv` cuenta los puntos. Un número puede variar un poco donde lo dice la clave.",
  },
  cards: {
    title: "Tarjetas de los bloques",
    lead: "Tarjetas para los bloques: en palabras, con el color de su familia, y en Haskell. Los bloques que solo van dentro de otros y los ejemplos grandes no tienen. Impresas, ocho llenan una hoja; elige las hojas que necesitas y recórtalas. Los alumnos ponen con ellas un programa, leen los de los demás y lo escriben.",
  },
  poster: {
    title: "El lenguaje en una hoja",
    lead: "Los bloques de las tarjetas con su Haskell, para la pared. Llenan una hoja A3 apaisada; para A4, que la impresora la reduzca.",
    roles: {
      event: "Ocurre en un momento:",
      state: "Siempre tiene un valor:",
      command: "Se envía al robot:",
    },
  },
  sheets: {
    "hello-robot": {
      tasks: [
        {
          say: "El robot debe estar 3 metros más adelante después de 10 segundos. ¿Qué número?",
          answer: "0,3 (en el programa 0.3)",
        },
        {
          say: "Dibuja dónde está `Velocity (-0.2) 0` después de 5 segundos y después de 10.",
          answer: "1 metro y 2 metros detrás del inicio",
        },
      ],
      unplugged: {
        title: "el robot que nunca se para",
        steps: [
          "Un alumno es el robot y está en una línea. Otro es el programa y tiene una tarjeta: 1 paso por segundo.",
          "La clase cuenta los segundos en voz alta. El robot hace lo que dice la tarjeta mientras hay tarjeta.",
          "El programa enseña otra tarjeta: 2 pasos, o 1 paso atrás. Pregunta: ¿cuándo se para el robot? (Cuando una tarjeta dice 0.)",
        ],
      },
    },
    "turn-on-the-spot": {
      tasks: [
        {
          say: "¿Cuánto tarda una vuelta entera con `Velocity 0 0.5`? Una vuelta entera es 6,28.",
          answer: "unos 12,6 segundos",
        },
        {say: "¿Qué segundo número gira un cuarto (1,57) a la derecha en 2 segundos?", answer: "unos −0,79"},
      ],
      unplugged: {
        title: "radianes con una cuerda",
        steps: [
          "Por parejas dibujan con tiza un círculo en el suelo, con una cuerda sujeta en el centro.",
          "Ponen la misma cuerda a lo largo del círculo y marcan cuántas veces cabe: algo más de seis.",
          "Una cuerda a lo largo del círculo es un radián. Poneos en el centro y girad uno, y después tres.",
        ],
      },
    },
    "round-the-box": {
      tasks: [
        {
          say: "¿Qué radio tiene el círculo de `Velocity 0.4 0.2`?",
          answer: "2 metros (0,4 dividido entre 0,2)",
        },
        {
          say: "Busca otros dos números para el mismo círculo, a la mitad de velocidad.",
          answer: "`Velocity 0.2 0.1`",
        },
      ],
      unplugged: {
        title: "andar en círculo",
        steps: [
          "Un alumno da un paso adelante y gira un poco a la izquierda, una y otra vez. Otros marcan el camino.",
          "Ahora los giros son más pequeños. ¿El círculo es más grande o más pequeño?",
          "Ahora el paso y el giro van a la vez: es lo que hace el robot.",
        ],
      },
    },
    "light-and-motion": {
      tasks: [
        {
          say: "Escribe el valor para: ir hacia atrás con 0,1, primera luz naranja.",
          answer: "`(Velocity (-0.1) 0, Led1 Orange)`",
        },
        {
          say: "Un programa tiene `Led1 Red` y `Led1 Green` uno al lado del otro. ¿Qué tiene de raro?",
          answer: "Dos valores para una luz: se reemplazan uno a otro.",
        },
      ],
      unplugged: {
        title: "una orquesta",
        steps: [
          "Tres alumnos reciben una tarjeta: dar palmadas, dar golpes con el pie, tararear. Todos empiezan cuando dices «ya».",
          "Se ponen en otro orden y empiezan otra vez. ¿Qué ha cambiado? (Nada.)",
          "Da a un alumno dos tarjetas que no se pueden hacer juntas: sentado, de pie. ¿Qué pasa?",
        ],
      },
    },
    faster: {
      tasks: [
        {
          say: "La velocidad es 0 y se suma 0,01 50 veces por segundo. ¿Cuánto es después de 1 segundo?",
          answer: "0,5 metros por segundo",
        },
        {say: "Completa: `slower (Velocity vl va) = Velocity (vl ___ 0.01) va`", answer: "`-`"},
      ],
      unplugged: {
        title: "una máquina de números",
        steps: [
          "Un alumno detrás de una mesa es una máquina: entra un número en una nota y sale más 2.",
          "Lo que sale vuelve a entrar. La clase adivina el número después de cinco veces.",
          "Otras reglas: el doble, uno menos. ¿Cuál crece más rápido?",
        ],
      },
    },
    "stop-in-time": {
      tasks: [
        {say: "¿Qué da `go` para x = 0,5, para x = 0,99 y para x = 1?", answer: "0,3, 0,3 y 0"},
        {
          say: "Añade una línea: entre 1 y 1,5 avanza a 0,1.",
          answer: "`| x < 1.5 = Velocity 0.1 0` como segunda línea",
        },
      ],
      unplugged: {
        title: "decide la clase",
        steps: [
          "Un alumno anda. Después de cada paso dice en voz alta cuántos pasos lleva.",
          "La clase es la función y responde cada vez: «menos de 5: sigue; si no: quieto».",
          "Pon al alumno dos pasos más atrás y seguid. ¿Qué responde ahora la clase?",
        ],
      },
    },
    bump: {
      tasks: [
        {say: "El parachoques se pulsa 3 veces y se suelta 3 veces. ¿Cuántos eventos?", answer: "6"},
        {
          say: "¿Evento o estado: un choque, la velocidad, un botón, la posición?",
          answer: "evento, estado, evento, estado",
        },
      ],
      unplugged: {
        title: "palmada o nada",
        steps: [
          "Levantas una tarjeta y la bajas. Las dos cosas son eventos. La clase responde a cada una con una palmada.",
          "Regla nueva: palmada cuando la tarjeta sube, nada cuando baja. «Nada» también es una respuesta.",
          "Quien da palmadas mientras la tarjeta está arriba ha tomado un evento por un estado.",
        ],
      },
    },
    "which-side": {
      tasks: [
        {
          say: "Casos en este orden: cualquier lado, lado izquierdo. ¿Cuándo se usa el segundo?",
          answer: "Nunca: en el primero encaja todo.",
        },
        {
          say: "Escribe el patrón para: se suelta el parachoques derecho.",
          answer: "`Bumper RightBumper Released`",
        },
      ],
      unplugged: {
        title: "la oficina de correos",
        steps: [
          "Hay cajas en fila: «cartas rojas», «cartas para Ada», «todas las demás». Una carta va a la primera caja en la que encaja.",
          "Clasificad diez cartas. ¿Adónde va una carta roja para Ada?",
          "Poned «todas las demás» la primera y clasificad otra vez. ¿Qué hay en las otras cajas?",
        ],
      },
    },
  },
  tests: {
    "1": [
      {
        ask: "¿Cuánto avanza el robot en 5 segundos, en centímetros?",
        why: "0,3 metros en cada uno de los 5 segundos.",
      },
      {
        ask: "¿Cuándo se para por sí mismo?",
        answers: ["Después de 1 metro", "Después de 5 segundos", "Nunca"],
        why: "Una velocidad vale hasta que llega otra.",
      },
      {
        ask: "¿Qué valor va en círculo hacia la derecha?",
        answers: ["`Velocity 0.3 0`", "`Velocity 0 (-0.3)`", "`Velocity 0.3 (-0.3)`"],
        why: "Avanza y gira a la derecha a la vez.",
      },
      {
        ask: "¿Qué hace este programa?",
        answers: ["Avanza y después se enciende la luz", "Las dos cosas desde el principio", "Solo la luz"],
        why: "Los valores están uno al lado del otro.",
      },
      {
        ask: "¿Cuántas veces se pregunta si `x < 1`?",
        answers: ["Una vez, al principio", "Con cada informe del robot", "Cuando llega"],
        why: "A una función de un estado se le pregunta una y otra vez.",
      },
      {
        ask: "El robot choca 3 veces y cada vez queda libre. ¿Cuántos sonidos?",
        why: "Pulsado y suelto son dos eventos, tres veces.",
      },
      {
        ask: "¿Qué hace el robot en la pared?",
        answers: ["Sigue empujando", "Va hacia atrás", "Se para"],
        why: "`go` se envía una y otra vez y reemplaza lo que envió `back`.",
      },
      {
        ask: "¿Cuándo responde `back`?",
        answers: [
          "Cuando han ocurrido un choque y un agujero",
          "A cada choque y a cada cambio del suelo",
          "Solo a lo primero que llega",
        ],
        why: "`Either` es una cosa o la otra, cada vez.",
      },
    ],
    "2": [
      {
        ask: "El parachoques se pulsa 3 veces. ¿Qué número hay entonces en la memoria?",
        why: "Empieza con 0, y se suma 2 cada vez que se pulsa.",
      },
      {
        ask: "¿Qué hace el robot después de un choque?",
        answers: ["Va hacia atrás", "Se para", "Sigue recto como antes"],
        why: "`drive` no mira la memoria.",
      },
      {
        ask: "¿Qué hace el robot al principio?",
        answers: ["Va recto", "Va hacia atrás", "Gira"],
        why: "La memoria empieza con el primer caso.",
      },
      {
        ask: "¿Qué hace el programa en el segundo que sigue a un choque?",
        answers: ["Espera un segundo", "Compara el reloj una y otra vez", "Nada"],
        why: "Nada espera; decide el reloj.",
      },
      {
        ask: "Un programa con `StdGen` se ejecuta dos veces con la misma semilla. ¿Qué cambia?",
        answers: ["Nada", "Todo", "Solo el primer giro"],
        why: "La misma semilla da los mismos números.",
      },
      {
        ask: "¿Cuándo empieza `turn 90`?",
        answers: ["A la vez que `drive`", "Cuando ha terminado `drive 100`", "Después de un segundo"],
        why: "Los pasos de una tarea van uno después de otro.",
      },
      {
        ask: "¿Cuántas esquinas tiene la figura que recorre el robot?",
        why: "Cinco veces 72 grados es una vuelta entera.",
      },
      {
        ask: "¿Cuándo termina este programa?",
        answers: ["Después de 5 metros", "Cuando han terminado las dos tareas", "Después de 4 segundos"],
        why: "`race` termina con la primera; 5 metros tardan más.",
      },
    ],
  },
}
