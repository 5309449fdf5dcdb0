package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.recruit.agent.BodyModules.at;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.UUID;
import org.dfra.agent.HelpCall;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.LegGoal;
import org.dfra.core.behavior.Progress;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What an agent's process began that died, and its next one finds. */
class OrphanedTripTest extends BodyFixture {

  private final List<RobotBody> dead = new ArrayList<>(); // who must not do anything any more

  @AfterEach
  void endTheDead() {
    dead.forEach(RobotBody::close);
  }

  /** The agent's process dies, and what drives does not; what the dead one says is not heard. */
  private UUID bereave() {
    body.go(
        CALL,
        Long.MAX_VALUE,
        new Body.Journey() {
          @Override
          public void arrived() {}

          @Override
          public void failed(String why) {}
        });
    modules.step(1);
    dead.add(body);
    body = body();
    return Objects.requireNonNull(driver.status().goal());
  }

  @Test
  void whatItsDeadProcessHasBegunIsFollowed() {
    UUID goal = bereave();
    body.go(CALL, Long.MAX_VALUE, journey);
    modules.step(3);
    assertThat(driver.status().goal()).as("it goes on").isEqualTo(goal);
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
    driver.progress = Progress.reached("it is there");
    modules.step(1);
    assertThat(told).containsExactly("arrived");
    assertThat(driver.status().goal()).isEqualTo(goal);
  }

  @Test
  void whatItsDeadProcessHasBegunIsCalledOff() {
    UUID goal = bereave();
    body.go(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    body.resume();
    modules.step(1);
    assertThat(driver.status().goal()).isEqualTo(goal);
    assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
  }

  @Test
  void whatItsDeadProcessHasBegunEndsAsSoonAsItIsFoundWhereItHelpsNobody() {
    UUID goal = bereave();
    modules.hide(driver);
    body.resume();
    modules.step(1);
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
    modules.show(driver);
    modules.step(1);
    assertThat(driver.status().goal()).isEqualTo(goal);
    assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
  }

  @Test
  void whatItsDeadProcessHasBegunEndsWhereItIsCalledElsewhere() {
    UUID goal = bereave();
    HelpCall other =
        new HelpCall("mine", at(5, 5), Duration.ofSeconds(20), Duration.ofSeconds(100));
    body.go(other, Long.MAX_VALUE, journey);
    modules.step(2);
    assertThat(driver.goal).isEqualTo(new LegGoal(null, other.place(), 0.7));
    assertThat(driver.status().goal()).isNotEqualTo(goal);
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
  }

  @Test
  void whatSomebodyElseBeganSinceIsLeftAlone() throws RemoteException {
    UUID unused = bereave();
    driver.cancel();
    UUID others = driver.pursue(new LegGoal(null, at(1, 1), 1));
    body.resume();
    modules.step(2);
    assertThat(driver.status().goal()).isEqualTo(others);
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
  }
}
