package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.recruit.agent.BodyModules.at;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.UUID;
import org.dfra.behavior.HomeGoal;
import org.dfra.behavior.LegGoal;
import org.dfra.behavior.PathGoal;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.persona.EmergencyStopAttributes;
import org.dfra.recruit.agent.BodyModules.Battery;
import org.dfra.recruit.agent.BodyModules.Follower;
import org.dfra.recruit.agent.BodyModules.Homing;
import org.dfra.recruit.agent.BodyModules.Position;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whether a robot may be asked to help at all. */
class FreeBodyTest extends BodyFixture {

  @ParameterizedTest
  @ValueSource(ints = {-3600, 3600})
  void oneWhoseClockIsSetKnowsForAsLongWhereItIs(int seconds) {
    position.see(0, 0);
    modules.step(0.1);
    modules.set = Duration.ofSeconds(seconds);
    modules.step(1.6);
    assertThat(body.isAvailable()).as("it has just seen where it is").isTrue();
    modules.step(0.5);
    assertThat(body.isAvailable()).as("its position is too old").isFalse();
    position.see(0, 0);
    modules.step(0.1);
    assertThat(body.isAvailable()).isTrue();
  }

  @Test
  void oneThatDoesNotKnowWhereItIsIsNotAsked() {
    assertThat(body.isAvailable()).isTrue();
    modules.step(1.7); // seconds since it knew
    assertThat(body.isAvailable()).isTrue();
    modules.step(0.5);
    assertThat(body.isAvailable()).as("its position is too old").isFalse();
    assertThat(body.eta(CALL.position())).isEmpty();
    modules.end(position);
    Position again = modules.add(new Position(modules.context("position")));
    modules.step(2); // until it is listened to
    again.see(3, 0);
    modules.step(0.1);
    assertThat(body.isAvailable()).as("the sensor came back").isTrue();
    assertThat(body.eta(CALL.position())).isPresent();
  }

  @Test
  void oneWithLittleChargeIsNotAsked() {
    assertThat(body.battery()).as("it does not know").isEqualTo(1);
    Battery battery = modules.add(new Battery(modules.context("battery")));
    modules.step(2);
    charge(battery, 0.6);
    assertThat(body.battery()).isEqualTo(0.6);
    assertThat(body.isAvailable()).isTrue();
    charge(battery, 0.2);
    assertThat(body.isAvailable()).as("no more than its reserve").isFalse();
    charge(battery, null);
    assertThat(body.battery()).as("it does not know any more").isEqualTo(1);
    charge(battery, 0.1);
    modules.step(301);
    assertThat(body.battery()).as("nobody knows after five minutes").isEqualTo(1);
  }

  private void charge(Battery battery, Double remaining) {
    battery.see(remaining);
    position.see(0, 0);
    modules.step(0.1);
  }

  @Test
  void oneThatItsOperatorSendsSomewhereIsNotAsked() throws RemoteException {
    Follower follower = modules.add(new Follower(modules.context("follow_waypoints")));
    Homing homing = modules.add(new Homing(modules.context("return_home")));
    modules.step(2);
    UUID leg = driver.pursue(new LegGoal(null, at(1, 1), 1));
    assertThat(isFreeAfterAWhile()).as("it drives somewhere").isFalse();
    driver.pause();
    assertThat(isFreeAfterAWhile()).as("it waits on its way").isFalse();
    driver.cancelUnattended(leg); // as a program that has reached what it wanted
    assertThat(isFreeAfterAWhile())
        .as("its operator had it wait, and did not let it go on")
        .isFalse();
    leg = driver.pursue(new LegGoal(null, at(1, 1), 1));
    modules.step(0.5);
    driver.cancelUnattended(leg);
    assertThat(isFreeAfterAWhile()).isTrue();
    UUID path = follower.pursue(new PathGoal(null, List.of(at(1, 1)), 1));
    assertThat(isFreeAfterAWhile()).as("it follows a path").isFalse();
    UUID raster = search.pursue(FIELD);
    assertThat(isFreeAfterAWhile()).as("the path is its search's").isTrue();
    search.cancel();
    follower.cancel();
    UUID home = homing.pursue(new HomeGoal(1));
    assertThat(isFreeAfterAWhile()).as("it drives home").isFalse();
    modules.end(homing);
    assertThat(isFreeAfterAWhile()).as("what drove it is gone").isTrue();
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    assertThat(isFreeAfterAWhile()).as("its own way").isTrue();
    assertThat(List.of(leg, path, raster, home)).doesNotHaveDuplicates();
  }

  private boolean isFreeAfterAWhile() {
    modules.step(0.5);
    position.see(0, 0);
    modules.step(0.1);
    return body.isAvailable();
  }

  @Test
  void whatWasUnderWayBeforeItBeganCountsToo() throws RemoteException {
    UUID unused = driver.pursue(new LegGoal(null, at(1, 1), 1));
    driver.pause(); // and tells nothing more
    modules.step(1);
    body.close();
    body = body();
    assertThat(isFreeAfterAWhile()).isFalse();
  }

  @Test
  void oneThatIsStoppedForAnEmergencyIsNotAsked() {
    UUID drive = UUID.randomUUID();
    listDrive(drive, false);
    assertThat(isFreeAfterAWhile()).isTrue();
    listDrive(drive, true);
    assertThat(isFreeAfterAWhile()).isFalse();
  }

  private void listDrive(UUID id, boolean isStopped) {
    DriveEffector drive = BodyModules.stub(DriveEffector.class, () -> {});
    modules.list(id, "drive", drive, new EmergencyStopAttributes(isStopped, "somebody", null));
  }
}
