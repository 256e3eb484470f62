"""All sets of models, by name."""
import bathroom
import bedroom
import bricks
import building
import classroom
import dungeon
import garden
import houses
import kitchen
import living
import office
import outdoors
import platform_game
import restaurant
import shapes
import shop
import streets
import vehicles

SETS = {
    "living": living, "kitchen": kitchen, "bedroom": bedroom, "bathroom": bathroom, "office": office,
    "classroom": classroom, "restaurant": restaurant, "building": building, "shapes": shapes,
    "bricks": bricks, "platform": platform_game, "dungeon": dungeon, "streets": streets,
    "vehicles": vehicles, "houses": houses, "outdoors": outdoors, "garden": garden, "shop": shop,
}
