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
  void theFoundationDemoReportsItsStepsAndLeavesNothingBehind() throws Exception {
    play(
        "foundation",
        "A robot starts",
        "Phoenix, the activation daemon, is process",
        "Robot atrv1 is up",
        "A client finds a receiver",
        "found atrv1/gps_front (GPSProxy) through discovery and lookup",
        "27.950600° N, 82.457200° W",
        "kill -9 of the receiver's virtual machine",
        "The same proxy answered again after",
        "kill -STOP",
        "got no answer within 2000 ms",
        "Activation of an object",
        "kill -9 of phoenix",
        "The receiver still answered",
        "registrations are present, and the running groups were adopted, not started twice",
        "The adopted group was killed too",
        "The proxy in the module's own virtual machine",
        "processes of this demonstration have ended",
        "Measured",
        "cold start of everything to position read",
        "GPS group killed to same proxy answering",
        "silent server reported",
        "activation of an object in a live group",
        "phoenix restart to ready, 1000 objects",
        "same-VM proxy call over the direct call");
  }
}
