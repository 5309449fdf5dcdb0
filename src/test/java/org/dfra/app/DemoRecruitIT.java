package org.dfra.app;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;

/**
 * {@code ./dfra demo recruit}, which takes minutes. {@code org.dfra.autonomy.RecruitmentAgentsIT}
 * tries its parts in the everyday tier.
 */
class DemoRecruitIT extends DemoPlay {

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes minutes")
  void theRecruitmentDemoReportsItsStepsAndLeavesNothingBehind() throws Exception {
    play(
        "recruit",
        "The team",
        "appears: its agent can observe mine",
        "no robot within reach of uav can observe \"gold\"; other robots observe mine",
        "A helper comes, observes, and is released",
        "uav calls for a robot that can observe \"mine\", 12 m east and 11 m north",
        "observes for 8 s of the robots' time",
        "uav has seen enough and releases",
        "A helper dies on its way, and is replaced",
        "Phoenix restarts the agent, which finds no robot to drive",
        "The requester becomes unreachable",
        "is free again without a release",
        "which interrupted its search to help and then continued it, has searched",
        "messages were sent",
        "processes of this demonstration have ended",
        "Measured",
        "death to another on its way",
        "robots that are not free at the end",
        "seconds in which two helped at once",
        "recruited robots that had not been searching",
        "searches that were left and did not go on");
  }
}
