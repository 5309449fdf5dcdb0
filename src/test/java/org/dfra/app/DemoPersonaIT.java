package org.dfra.app;

import org.junit.jupiter.api.Test;

/** {@code ./dfra demo persona}. */
class DemoPersonaIT extends DemoPlay {

  @Test
  void thePersonaTellsItsStoryAndLeavesNothingBehind() throws Exception {
    play(
        "persona",
        "Two robots come up",
        "Robot atrv1 is up after",
        "Robot atrv2 is up after",
        "A client meets them",
        "Robot atrv1, scout: fresh goals Search the north field",
        "limitations It drives on firm ground",
        "gps_front ready GPSSensor 1.0 2D/3D fix,",
        "gps_rear ready GPSSensor 1.0",
        "Robot atrv2, carrier: fresh goals",
        "It asks by what is needed, not by name",
        "with a 3-D fix, at 1 Hz or more\": 4 answers",
        "atrv2/gps_rear 27.950797° N, 82.457000° W",
        "It listens to all four",
        "Reading no.",
        "kill -9 of a receiver's process, while a client listens",
        "The client did nothing for either.",
        "so a gap is seen and counted",
        "kill -9 under a call",
        "atrv1/gps_front answered first.",
        "the call was answered by atrv1/gps_rear; the caller saw no failure",
        "kill -STOP: a process falls silent",
        "the client's subscription to it reported that it is interrupted",
        "atrv2/gps_front (stopped) 0 - - -",
        "let go on (kill -CONT)",
        "A robot's registrar is gone for a while",
        "Robot atrv1, scout: STALE, last vouched for",
        "atrv1/gps_front answered a call after",
        "Robot atrv1, scout: fresh",
        "The robot is changed while it works",
        "gps_roof ready GPSSensor 1.0",
        "gps_roof ready GPSSensor 1.1",
        "It was removed, and gone from the robot's persona",
        "0 were lost",
        "All is shut down: none of the",
        "Measured",
        "cold start of both robots to all modules working and shown",
        "a question by capability, answered from the client's cache",
        "receiver killed to its readings coming again",
        "receiver killed to the client's lease counted",
        "readings missed in the gap but not counted 0",
        "call to a killed receiver answered",
        "silent receiver reported",
        "longest wait for a reading while another receiver is silent",
        "registrar dead to its robot shown as stale",
        "phoenix started again to the robot fresh",
        "module added to it working and shown",
        "module replaced to the newer one working and shown",
        "module removed to it gone",
        "readings lost while the robot was changed 0",
        "longest wait for a reading while the robot was changed");
  }
}
