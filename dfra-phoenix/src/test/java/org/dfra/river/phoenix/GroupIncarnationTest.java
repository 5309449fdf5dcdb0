package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.rmi.activation.ActivationException;
import org.junit.jupiter.api.Test;

/** Which process an incarnation accepts. */
class GroupIncarnationTest {

  private static final ProcessIdentity PROCESS = new ProcessIdentity(4711, "tick 1 of boot x");

  @Test
  void onlyTheProcessOfTheIncarnationThatAwaitsOneIsAccepted() throws Exception {
    GroupIncarnation past = GroupIncarnation.past(6);
    GroupIncarnation next = past.next();
    next.requireUnlaunched("1-group", 7);
    assertRefused(past, 6);
    assertRefused(next, 6);
    assertRefused(next, 8);
    next.launched(PROCESS);
    assertRefused(next, 7);
    assertThat(next.process()).isEqualTo(PROCESS);
    next.ended();
    assertRefused(next, 7);
  }

  private static void assertRefused(GroupIncarnation incarnation, long number) {
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> incarnation.requireUnlaunched("1-group", number))
        .withMessageContaining(
            "the process of incarnation %d of group 1-group is not awaited", number);
  }
}
