package org.dfra.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.ObjectStreamClass;
import java.time.Instant;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.junit.jupiter.api.Test;

class BehaviorStatusTest {

  private static final Instant NOW = Instant.parse("2026-11-23T00:00:00Z");
  private static final UUID GOAL = new UUID(1, 2);

  @Test
  void oneOfAnEarlierVersionIsReadAndCountsNoParts() throws Exception {
    Object earlier =
        new org.dfra.behavior.earlier.BehaviorStatus(
            NOW, GOAL, Phase.RUNNING, "waypoint 2 of 3", 0.4, 1);
    assertThat(read(earlier, BehaviorStatus.class))
        .isEqualTo(
            new BehaviorStatus(NOW, GOAL, Phase.RUNNING, "waypoint 2 of 3", 0.4, 1, null, 0, 0));
  }

  @Test
  void anEarlierVersionReadsOneThatCountsItsParts() throws Exception {
    Object now =
        new BehaviorStatus(NOW, GOAL, Phase.RUNNING, "waypoint 2 of 3", 0.4, 1, null, 1, 3);
    assertThat(read(now, org.dfra.behavior.earlier.BehaviorStatus.class))
        .isEqualTo(
            new org.dfra.behavior.earlier.BehaviorStatus(
                NOW, GOAL, Phase.RUNNING, "waypoint 2 of 3", 0.4, 1));
  }

  /** What is written by one version, as the other reads it. */
  private static Object read(Object written, Class<?> other)
      throws IOException, ClassNotFoundException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(written);
    }
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())) {
          @Override
          protected Class<?> resolveClass(ObjectStreamClass described)
              throws IOException, ClassNotFoundException {
            return described.getName().equals(written.getClass().getName())
                ? other
                : super.resolveClass(described);
          }
        }) {
      return in.readObject();
    }
  }

  @Test
  void refusesMorePartsDoneThanThereAre() {
    assertThatThrownBy(
            () -> new BehaviorStatus(NOW, GOAL, Phase.RUNNING, "it goes", 0, 0, null, 4, 3))
        .hasMessage("parts done 4 is outside 0 to 3, the parts of the goal");
  }
}
