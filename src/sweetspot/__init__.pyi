"""The public front door; `lazy_loader` reads this file, and so do type checkers."""

from . import catalog
from .analysis.bat_analysis import Analysis, analyse, exit_speed_of, hit_at
from .analysis.certification.simulated_test import Certification, certify
from .analysis.comparison import Comparison, compare
from .analysis.full_play import play, plays
from .catalog.bats import bat
from .catalog.implements import implement
from .catalog.standard_hit import standard_analysis, standard_conditions, standard_flight
from .collision.coupled import hit
from .collision.hit_in_space import Contact, strike, strikes
from .collision.impact import Impact
from .collision.kernel import hits, hits_with_motion
from .collision.oblique_contact import Friction
from .dynamics.beam import BeamModel, beam_model
from .dynamics.bending import bending_modes
from .dynamics.hands import gripped
from .dynamics.hoop import hoop_modes
from .dynamics.mode_assembly import all_modes
from .dynamics.reduction import ReducedBat, reduced_bat
from .dynamics.rigid import RigidBody, centre_of_percussion, effective_mass, rigid_body
from .equipment.ball import Ball, RestitutionLaw
from .equipment.bat import Bat
from .equipment.material import Material
from .errors import InputError, SweetspotError
from .flight.air import Air, Wind
from .flight.all_parks import landings_everywhere
from .flight.conditions import FlightConditions
from .flight.flying import fly
from .flight.kernel import flights
from .flight.trajectory import Flight
from .motion.ball_motion import BallMotion, BallMotions, launched
from .motion.swing import Conditions, Hands, Pitch, Swing
from .motion.swing_path import SwingPath, Swings
from .paper.chain import paper_rows

__version__: str

__all__ = [
    "Air",
    "Analysis",
    "Ball",
    "BallMotion",
    "BallMotions",
    "Bat",
    "BeamModel",
    "Certification",
    "Comparison",
    "Conditions",
    "Contact",
    "Flight",
    "FlightConditions",
    "Friction",
    "Hands",
    "Impact",
    "InputError",
    "Material",
    "Pitch",
    "ReducedBat",
    "RestitutionLaw",
    "RigidBody",
    "SweetspotError",
    "Swing",
    "SwingPath",
    "Swings",
    "Wind",
    "all_modes",
    "analyse",
    "bat",
    "beam_model",
    "bending_modes",
    "catalog",
    "centre_of_percussion",
    "certify",
    "compare",
    "effective_mass",
    "exit_speed_of",
    "flights",
    "fly",
    "gripped",
    "hit",
    "hit_at",
    "hits",
    "hits_with_motion",
    "hoop_modes",
    "implement",
    "landings_everywhere",
    "launched",
    "paper_rows",
    "play",
    "plays",
    "reduced_bat",
    "rigid_body",
    "standard_analysis",
    "standard_conditions",
    "standard_flight",
    "strike",
    "strikes",
]
