"""All sets of models, by name."""
import bathroom
import bedroom
import bricks
import building
import classroom
import dungeon
import kitchen
import living
import office
import platform_game
import restaurant
import shapes
import street

SETS = {
    "living": living, "kitchen": kitchen, "bedroom": bedroom, "bathroom": bathroom, "office": office,
    "classroom": classroom, "restaurant": restaurant, "building": building, "shapes": shapes,
    "bricks": bricks, "platform": platform_game, "dungeon": dungeon, "street": street,
}
