package org.dfra.app;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;

/**
 * {@code ./dfra demo foundation}, which takes minutes. What it shows on the way, the tests of
 * {@code org.dfra.phoenix} try one by one in the everyday tier.
 */
class DemoFoundationIT extends DemoPlay {

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes minutes")
  void theFoundationTellsItsStoryAndLeavesNothingBehind() throws Exception {
    play(
        "foundation",
        "A robot comes up",
        "Phoenix, the activation daemon, is process",
        "Robot atrv1 is up",
        "A client finds a receiver",
        "found atrv1/gps_front (GPSProxy) through discovery and lookup",
        "27.950600° N, 82.457200° W",
        "kill -9 of the receiver's virtual machine",
        "The same proxy answered again after",
        "kill -STOP",
        "got no answer within 2000 ms",
        "Activation itself",
        "kill -9 of phoenix",
        "The receiver answered on",
        "registrations are there, and the living groups were taken back, not doubled",
        "The adopted group was killed too",
        "The proxy in the module's own virtual machine",
        "All is shut down: none of the",
        "Measured",
        "cold start of everything to position read",
        "GPS group killed to same proxy answering",
        "silent server reported",
        "activation of an object in a live group",
        "phoenix restart to ready, 1000 objects",
        "same-VM proxy call over the direct call");
  }
}
