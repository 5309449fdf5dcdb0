package org.dfra.attack.registrar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceRegistration;
import net.jini.lookup.entry.Name;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.attack.kit.Fakes;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.benchmarks.attack.SourceSockets;
import org.dfra.directory.RegistrationRefusedException;
import org.dfra.river.access.AddressRange;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.entry.PersonaEntry;
import org.dfra.river.entry.SensorEntry;
import org.dfra.river.registrar.RegistrationPolicy;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Registrations in the registrar of robot eta, which runs on two computers: the registrar's, and
 * the operator's.
 */
@Timeout(60)
class RegistrarDoorTest {

  private static final ServiceID DRIVE = new ServiceID(0xd, 0xe);
  private static final Entry[] NONE = {};

  private final AttackHosts hosts = AttackHosts.assumed();
  private EmbeddedRegistrar reggie;
  private ServiceRegistrar own;
  private ServiceRegistrar second;
  private ServiceRegistrar stranger;
  private ServiceRegistrar otherStranger;

  @BeforeEach
  void start() throws Exception {
    RegistrationPolicy policy =
        new RegistrationPolicy("eta", List.of(AddressRange.of(hosts.operator())));
    reggie =
        new EmbeddedRegistrar(hosts.robot(), 0, List.of(), Duration.ofSeconds(60), policy, Map.of())
            .start();
    own = reggie.registrar();
    second = from(hosts.operator());
    stranger = from(hosts.attacker());
    otherStranger = from(hosts.otherAttacker());
  }

  private ServiceRegistrar from(String address) throws Exception {
    return SourceBoundProxies.of(own, SourceSockets.from(address));
  }

  @AfterEach
  void end() throws Exception {
    if (reggie != null) {
      reggie.close();
    }
  }

  private static void assertRefused(ThrowingCallable call, String... parts) {
    assertThatThrownBy(call)
        .isInstanceOf(RegistrationRefusedException.class)
        .message()
        .contains(parts);
  }

  @Test
  void theDrivesServiceIdIsTakenFromTheRobotsOwnComputersOnly() throws Exception {
    ServiceRegistration before = Fakes.register(own, DRIVE, "honest", Fakes.module("eta", "drive"));
    assertRefused(
        () -> Fakes.register(stranger, DRIVE, "fake", new Name("drive")),
        DRIVE.toString(),
        hosts.attacker());
    assertThat(Fakes.proxy(own, DRIVE)).contains("honest");
    before.getLease().renew(Fakes.LEASE_MILLIS);

    Fakes.register(own, DRIVE, "new incarnation", Fakes.module("eta", "drive"));
    assertThat(Fakes.proxy(own, DRIVE)).contains("new incarnation");
    Fakes.register(second, DRIVE, "on the second computer", Fakes.module("eta", "drive"));
    assertThat(Fakes.proxy(own, DRIVE)).contains("on the second computer");
  }

  @Test
  void noStrangerTakesTheDrivesServiceIdWhileTheDriveIsDown() throws Exception {
    Fakes.register(own, DRIVE, "honest", Fakes.module("eta", "drive")).getLease().cancel();
    assertThat(Fakes.proxy(own, DRIVE)).isEmpty();
    assertRefused(() -> Fakes.register(stranger, DRIVE, "fake"), "robot eta");
    Fakes.register(own, DRIVE, "new incarnation", Fakes.module("eta", "drive"));
    assertThat(Fakes.proxy(own, DRIVE)).contains("new incarnation");
  }

  @Test
  void theSameProxyWithoutServiceIdTakesNoRegistrationOver() throws Exception {
    Fakes.register(own, DRIVE, "honest", Fakes.module("eta", "drive"));
    assertRefused(() -> Fakes.register(stranger, null, "honest", new Name("x")), DRIVE.toString());
    assertThat(Fakes.register(own, null, "honest").getServiceID()).isEqualTo(DRIVE);
  }

  @Test
  void strangersDoNotReplaceEachOther() throws Exception {
    Fakes.register(stranger, DRIVE, "first", Fakes.module("theta", "drive"));
    assertRefused(() -> Fakes.register(otherStranger, DRIVE, "second"), hosts.attacker());
    ServiceRegistration again =
        Fakes.register(stranger, DRIVE, "third", Fakes.module("theta", "drive"));
    assertThat(Fakes.proxy(own, DRIVE)).contains("third");
    again.getLease().cancel();
    Fakes.register(otherStranger, DRIVE, "fourth");
    assertThat(Fakes.proxy(own, DRIVE)).contains("fourth");
  }

  @Test
  void nobodyElseClaimsToBeOfTheRobot() throws Exception {
    SensorEntry sensor = new SensorEntry();
    sensor.robot = "eta";
    sensor.name = "sonar";
    PersonaEntry persona = new PersonaEntry();
    persona.robot = "eta";
    for (Entry each : List.of(Fakes.module("eta", "sonar"), sensor, persona)) {
      assertRefused(() -> Fakes.register(stranger, null, "fake", each), "robot eta", "registrar");
      Fakes.register(second, null, "of the second computer " + each.getClass(), each);
    }
    Fakes.register(stranger, null, "a name is no claim", new Name("eta"));
    Fakes.register(stranger, null, "nor is a module's", Fakes.module("theta", "eta"));
  }

  @Test
  void norAfterwards() throws Exception {
    ModuleEntry claim = Fakes.module("eta", "sonar");
    ServiceRegistration fake =
        SourceBoundProxies.of(
            Fakes.register(stranger, null, "fake", Fakes.module("theta", "sonar")),
            hosts.attackerSockets());
    assertRefused(() -> fake.addAttributes(new Entry[] {claim}), "robot eta");
    assertRefused(() -> fake.setAttributes(new Entry[] {claim}), "robot eta");
    ModuleEntry robot = new ModuleEntry();
    robot.robot = "eta";
    assertRefused(
        () -> fake.modifyAttributes(new Entry[] {new ModuleEntry()}, new Entry[] {robot}),
        "robot eta");
    fake.setAttributes(new Entry[] {Fakes.module("theta", "camera")});
    Fakes.register(own, null, "honest").addAttributes(new Entry[] {claim});
  }

  @Test
  void anAddressRegistersSoManyServicesAndListeners() throws Exception {
    List<ServiceRegistration> fakes = new ArrayList<>();
    for (int i = 0; i < 256; i++) {
      fakes.add(Fakes.register(stranger, null, "fake " + i, NONE));
    }
    assertRefused(() -> Fakes.register(stranger, null, "one more"), "services", "256 allowed");
    Fakes.register(otherStranger, null, "another's");
    Fakes.register(own, null, "own");
    fakes.get(0).getLease().cancel();
    Fakes.register(stranger, null, "one more");
    for (int i = 0; i < 128; i++) {
      Fakes.listen(stranger);
    }
    assertRefused(() -> Fakes.listen(stranger), "listeners", "128 allowed");
    assertThat(Fakes.listen(own)).isNotEqualTo(Fakes.listen(otherStranger));
  }
}
