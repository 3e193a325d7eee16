"""
Word lists from which the three words of a pupil are drawn: nouns that children know, without letters beyond a to z.

253 English words give 16,194,277 triples, 311 German words 30,080,231, 327 Portuguese words 34,965,783,
283 Spanish words 22,665,187,
338 French words 38,614,472.
"""

from __future__ import annotations

import secrets

__all__ = ["WORD_LISTS", "draw_words", "read_words"]

WORDS_EACH = 3

WORD_LISTS: dict[str, tuple[str, ...]] = {
    "en": tuple(
        """
    acorn apple arrow badge baker balloon bamboo banana barn basket beach beaver berry bicycle bird blanket blossom
    boat bottle branch bread bridge broom brush bubble bucket butter button cabin cactus camel candle canyon carpet
    carrot castle cello cherry chess circle citrus cliff clock cloud clover coast cocoa comet compass copper coral
    cotton crane crayon cricket crown crystal cushion daisy dancer desert diamond dolphin donkey dragon drum eagle
    earth echo engine falcon family farmer feather fern fiddle field finger flag flame flower flute forest fossil
    fountain fox garden ginger giraffe glacier globe goat gold grape grass guitar hammer harbor harp hazel hedge
    hill honey horse island ivory jacket jasmine jelly jewel jungle kettle kite kitten koala ladder lagoon lamp
    lantern leaf lemon letter lilac lion lizard lobster lotus magnet mango maple marble meadow melon mint mirror
    monkey moon mountain muffin museum mustard napkin needle nest noodle nutmeg oasis ocean olive onion orange
    orchid otter owl paddle paint palace panda paper parrot peach peacock pearl pebble pencil penguin pepper piano
    picnic pigeon pillow pine planet plum pocket poem polar pony poppy potato prairie pumpkin puzzle rabbit raccoon
    radish rain rainbow raven ribbon river robin rocket rose ruby saddle sailor salmon sand school seal shadow sheep
    shell silver sister sketch snail snow soap sparrow spider spoon spring squirrel star stone storm straw summer
    sunset swan table tadpole teapot tiger toast tomato tower train treasure tree tulip tunnel turtle umbrella
    valley velvet violet violin voyage wagon walnut water whale wheat whistle window winter wizard wolf yellow zebra
    """.split()  # noqa: SIM905
    ),
    "de": tuple(
        """
    abend adler ahorn ampel anker apfel arbeit armband auge bach balkon ball bambus banane bank baum becher beere
    berg besen biber biene bild birke birne blatt blitz blume boden bogen boot brett brief brille brot brunnen buch
    buche bus dach dachs decke delfin dino distel dorf drache eiche eimer eis elch elefant ente erbse erde esel eule
    fabel fahne falke familie farbe farn feder feld fell fenster ferien feuer fisch flagge flamme flocke floh flosse
    fluss forelle freund frosch frucht fuchs funke gabel gans garten gecko geige gitarre glas glocke gold gras gurke
    hafen hahn hammer hamster hand harfe hase haus hecht hecke hemd herbst herz heu himmel hirsch holz honig hose
    hotel huhn hummel hund hut igel insel jacke jaguar kaffee kakao kaktus kamel kamin kanu karotte karte kastanie
    katze kegel keks kerze kiefer kino kirsche kissen klavier klee knopf koala koffer kompass korb korn krabbe kran
    kranz kreis krone kuchen kugel kuh lachs lama lampe land laterne laub leiter lerche licht linde linse luchs luft
    magnet mais mango mantel marder maus meer melone milch minze mohn mond motor muschel museum nadel nashorn nebel
    nelke nest netz nudel nuss ofen ohr olive onkel orange otter palme panda papier pappel park perle pfau pferd
    pinguin pinsel pirat planet pudding puma quelle rabe rad rakete regen reh reis reise ring ritter robbe rose
    rucksack saft salat salz sand schaf schale schatz schiff schirm schlitten schnee schrank schule schwan see segel
    seife seil silber socke sofa sommer sonne spatz specht spiegel spinne stadt stein stern stiefel storch strand
    stuhl sturm tafel tanne tante tasche tasse taube tee teich teller teppich tiger tinte tisch tomate topf traube
    traum treppe trommel tulpe turm ufer uhr umhang unke urlaub vase veilchen vogel wagen wal wald wasser weide
    welle wetter wiese wind winter wolf wolke wolle wurzel zange zebra zelt ziege zirkus zitrone zucker zug zweig
    zwerg
    """.split()  # noqa: SIM905
    ),
    "pt": tuple(
        """
    abacate abacaxi abelha agulha almofada ameixa amendoim amora anel arroz aveia avestruz azeitona azul bairro
    balde bambu bandeira barco batata bengala besouro bicicleta bigode bilhete biscoito bolo bolsa borboleta
    bosque brinquedo bule cabana cabra caderno caixa caju camelo caminho camisa caneta canguru canoa canto
    capivara caracol caramelo caranguejo carta carteiro carvalho casa casaco castelo cavalo cebola cenoura
    cereja chave chuva cidade cigarra cinema circo cobertor cocada coelho colher colina cometa concha coral
    coroa corrida cortina coruja cozinha cravo cristal dado damasco deserto dia diamante dinossauro disco doce
    domingo enxada erva ervilha escada escova espelho espiga esponja esquilo esquina estrada estrela farinha
    farol fazenda fera festa figo figura filhote fita flauta flor floresta foguete folha forno framboesa futebol
    gaita galho gancho garfo garrafa gato gaveta gigante girafa girassol goiaba golfinho gota grama grilo gruta
    guitarra harpa hora hotel iguana ilha jabuti jaca janta jaqueta jardim jarra jasmim javali joaninha jornal
    juba lagarto lago lanche lanterna laranja lente letra lhama limoeiro livro loja lontra lousa luva luz
    madeira mamute manga manteiga mapa mar marinheiro martelo massa mel melado melancia mesa metal milho mochila
    moeda moinho mola montanha morango morcego morro mosaico motor muralha muro museu nata navio neblina
    nebulosa neve ninho noite novelo nozes nuvem oceano oliva onda orquestra outono ovelha ovo palco palito
    palmeira panda pandeiro panela pano papagaio papel parque pedra peixe pena perfume pescador pinguim pinha
    pintor pipa pipoca pirata piscina planeta poema pomar ponte porta praia prato presente primavera pudim
    pulseira puma quadro quati queijo quintal rainha raposa raquete rede regador rei remo rio risada rocha rosa
    roupa rua sabonete safira saia salada salsa sapato sapo sardinha selo semente sereia sino sol sombra sonho
    sopa sorriso sorvete suco tambor tapete tatu teatro teia telhado tenda terra tesoura tigre tijolo tinta
    toalha toca tomate torrada torre touro trem trevo trigo trilho trompete tubo tucano tulipa turbante uniforme
    urso urubu vale varanda vaso vassoura vela veludo vento verde viagem vidro violeta violino
    vitrine xadrez xarope zebra zinco
    """.split()  # noqa: SIM905
    ),
    "es": tuple(
        """
    abeja abrigo aceituna acuario agenda aguja ajedrez alfombra almendra almohada amigo ancla anillo apio ardilla
    arena armario arroz bandera barco barrio bicicleta bigote boca bosque botella brisa bufanda burbuja caballo
    cabra cacao cactus cadena caja calabaza calle camello camisa campana canario cangrejo canguro caracol carpeta
    carta castillo cebolla cereza chaleco chocolate ciervo cine cinta ciruela ciudad clarinete coco cocodrilo cohete
    colina collar columpio cometa copa corona cuaderno cuchara cuento cuerda cueva dado delantal desierto diamante
    diente dinosaurio disco domingo dulce duna durazno elefante erizo escalera escoba escuela espejo espiga esponja
    estrella estufa faro farola fiesta flauta flecha flor fresa fruta fuego fuente gacela galaxia galleta garaje
    gato girasol globo goma gorra granja grillo guante guitarra hada hamaca harina helado helecho hierba hoja
    hormiga horno hotel huella huerto iguana invierno isla jaguar jalea jarra jinete jirafa joya jueves jugo koala
    lagarto lago laguna lana lancha lechuga lenteja libro lima linterna lirio llama llave lluvia loro lupa madera
    maleta mandarina mango manta manzana mapa mar margarita mariposa martes martillo medalla melena mercado mesa
    metal miel mochila molino moneda mosaico museo naranja nariz nata nevera nido nieve nube nuez oasis oliva olla
    orquesta oruga oso ostra oveja palabra palmera pan pantera papel paraguas parque pasillo pasta patata patio
    peine pelota perla perro piano piedra pijama pincel piragua pirata piscina pizarra planeta plata pluma pollo
    postal pradera primavera puerta pulpo queso quinoa radio rastrillo regla reloj remo rey roble rodilla rosa rueda
    sal salsa sandalia semilla sendero sierra silla sirena sombra sombrero taller tambor taza teatro tejado tela
    tenedor tesoro tienda tigre tijera toalla tomate torre tortuga tostada tren trigo trineo trompeta uva vaso
    velero ventana verano verde viaje viento violeta volante yate yogur zapato zorro zumo
    """.split()  # noqa: SIM905
    ),
    "fr": tuple(
        """
    abeille abricot agneau aigle album algue alpaga ananas ancre anorak arbre argent argile armoire atelier atlas
    automne avion avocat bagage bague balai balcon ballon bambou banane bandeau banjo barque bassin bateau beurre
    biche bijou billet biscuit bison blouson bocal bois bonbon bonnet botte bougie bouquet bourdon bouteille bouton
    bracelet branche brebis brioche brique brosse brouillard buisson bulle bureau cabane cactus cadeau cadre cahier
    caillou camion campagne canard canari cannelle carafe carnet carotte carreau carton cascade casque castor
    cerise chaise champ chanson chapeau chaton chemin cheval chocolat chouette ciel cigale cigogne cirque
    citron clown coffre colibri colline colombe compas compote concert coquille corail corbeau cornet coton couleur
    couronne coussin crabe cravate crayon crocus cuisine cuivre cygne danse dauphin dessin diamant domino dragon
    drapeau dune escargot fable falaise farine faucon fauteuil ferme feuille ficelle figue flamant fleur fleuve
    flocon fontaine fourmi fraise framboise fromage galette garage gare gazelle gazon girafe givre glace
    globe gomme gorille grange grenier grillon grotte guide guitare hamac hamster haricot harpe herbe hermine hibou
    hiver homard horloge iguane iris ivoire jaguar jardin jasmin jongleur jouet journal jungle koala laine lampe
    lanterne lapin lavande lentille lettre lilas lion livre losange loup loutre luciole lune lutin lynx magnolia
    maison mandarine manteau marbre marelle marmotte marron marteau matin melon menthe merle mimosa miroir montagne
    montre mouette moulin mousse mouton muguet musique myrtille nappe navire neige noisette nougat nuage oasis
    oiseau olive ombre orange orchestre oreiller oursin palais palmier panda panier papaye papier papillon parasol
    parfum patin pelle pendule perle perroquet persil phare photo piano pilote pinceau pingouin pinson pirate
    piscine pivoine plage planche pluie plume poche poisson poivre pomme pompon poney portail potiron poulpe
    prairie prune puits puzzle pyjama quiche radis raisin rameau raquette refuge renard rideau rocher roman rose
    roseau ruban ruche ruisseau sable sapin sardine savon soleil source souris statue stylo sucre tableau tambour
    tapis tartine tasse temple tigre timbre tissu tomate tonneau torrent tortue toucan toupie tournesol train
    tricot trompette truite tuile tulipe tunnel vague vallon vanille velours verger violon voilier voiture volcan
    voyage wagon yaourt
    """.split()  # noqa: SIM905
    ),
}


def draw_words(language: str) -> str:
    """Three random words of a language, or of English if there is no list of it."""
    words = WORD_LISTS.get(language.partition("-")[0].lower(), WORD_LISTS["en"])
    return " ".join(secrets.choice(words) for _ in range(WORDS_EACH))


def read_words(typed: str) -> str:
    """Typed words as they are stored: capitals, commas, hyphens and further spaces do not matter."""
    return " ".join("".join(c if c.isalpha() else " " for c in typed.lower()).split())
