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
  void recruitmentTellsItsStoryAndLeavesNothingBehind() throws Exception {
    play(
        "recruit",
        "The team",
        "appears: its agent can observe mine",
        "nobody in reach of uav can observe \"gold\"; others observe mine",
        "One comes, observes, and is released",
        "uav calls for somebody who can observe \"mine\", 12 m east and 11 m north",
        "observes for 8 s of the robots' time",
        "uav has seen enough and releases",
        "One dies on its way, and is replaced",
        "Phoenix brings the agent back, which finds no robot to drive",
        "The requester cannot be reached any more",
        "has freed itself, with nobody to tell it so",
        "which was called away from its search and went on with it, has searched",
        "letters were sent",
        "All is shut down: none of the",
        "Measured",
        "death to another on its way",
        "robots that are still bound to somebody",
        "seconds in which two helped at once",
        "recruited robots that had not been searching",
        "searches that were left and did not go on");
  }
}
