package org.dfra.river.registrar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.HashSet;
import java.util.Set;
import net.jini.core.lookup.ServiceID;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dfra.directory.RegistrationRefusedException;
import org.dfra.river.registrar.RegistrationRules.RegistrationOrigin;
import org.junit.jupiter.api.Test;

class RegistrationRulesTest {

  private static final RegistrationOrigin OWN = new RegistrationOrigin(null, true);
  private static final RegistrationOrigin ALLY = foreign(2);
  private static final RegistrationOrigin STRANGER = foreign(66);
  private static final ServiceID DRIVE = new ServiceID(1, 1);

  /** Bytes. */
  private static final long USUAL = 5_000;

  private final Set<ServiceID> services = new HashSet<>();
  private final Set<Long> listeners = new HashSet<>();
  private final RegistrationRules rules =
      new RegistrationRules(
          "eta",
          new RegistrationRules.LiveRegistrations() {
            @Override
            public Set<ServiceID> liveServices(Set<ServiceID> among) {
              return both(among, services);
            }

            @Override
            public Set<Long> liveListeners(Set<Long> among) {
              return both(among, listeners);
            }
          });

  private static <K> Set<K> both(Set<K> one, Set<K> other) {
    Set<K> both = new HashSet<>(one);
    boolean unused = both.retainAll(other);
    return both;
  }

  private static RegistrationOrigin foreign(int last) {
    try {
      byte[] address = {10, 0, (byte) (last >> 8), (byte) last};
      return new RegistrationOrigin(InetAddress.getByAddress(address), false);
    } catch (UnknownHostException e) {
      throw new AssertionError(e);
    }
  }

  private void register(RegistrationOrigin from, ServiceID id, boolean namesRobot) {
    register(from, id, namesRobot, USUAL);
  }

  private void register(RegistrationOrigin from, ServiceID id, boolean namesRobot, long bytes) {
    rules.checkService(from, id, namesRobot, bytes);
    boolean unused = services.add(id);
    rules.addService(from, id, namesRobot, bytes);
  }

  private void end(ServiceID id) {
    assertThat(services.remove(id)).isTrue();
  }

  private static void assertRefused(ThrowingCallable call, String... parts) {
    assertThatThrownBy(call)
        .isInstanceOf(RegistrationRefusedException.class)
        .message()
        .contains(parts);
  }

  @Test
  void aLivingRegistrationIsReplacedFromItsComputerOnly() {
    register(ALLY, DRIVE, false);
    register(ALLY, DRIVE, false);
    assertRefused(
        () -> register(STRANGER, DRIVE, false), DRIVE.toString(), "10.0.0.66", "10.0.0.2");
    end(DRIVE);
    register(STRANGER, DRIVE, false);
    assertRefused(() -> register(ALLY, DRIVE, false), "10.0.0.66");
    register(OWN, DRIVE, false);
    assertRefused(() -> register(STRANGER, DRIVE, false), DRIVE.toString());
  }

  @Test
  void whatIsListedFromNobodyKnowsWhereIsNotReplacedByOthers() {
    services.add(DRIVE);
    assertRefused(() -> register(STRANGER, DRIVE, false), "an unknown address");
    register(OWN, DRIVE, false);
  }

  @Test
  void twoUnknownAddressesAreNotTheSameComputer() {
    RegistrationOrigin unknown = new RegistrationOrigin(null, false);
    register(unknown, DRIVE, false);
    assertRefused(() -> register(unknown, DRIVE, false), "an unknown address");
  }

  @Test
  void theRobotsNameIsForItsOwnComputers() {
    ServiceID fake = new ServiceID(2, 2);
    assertRefused(
        () -> register(STRANGER, fake, true), "robot eta", "<registrar module-hosts=\"…\">");
    assertRefused(() -> rules.checkEntries(STRANGER, true), "robot eta");
    rules.checkEntries(STRANGER, false);
    rules.checkEntries(OWN, true);
    register(OWN, fake, true);
  }

  @Test
  void theRobotsServiceIdsAreForItsOwnComputersAlsoAfterTheirLeases() {
    register(OWN, DRIVE, true);
    end(DRIVE);
    assertRefused(() -> register(STRANGER, DRIVE, false), DRIVE.toString(), "robot eta");
    register(OWN, DRIVE, true);
  }

  @Test
  void theNewestServiceIdsOfTheRobotAreKept() {
    for (int i = 0; i <= RegistrationRules.MAX_RESERVED_IDS; i++) {
      ServiceID id = new ServiceID(3, i);
      register(OWN, id, true);
      end(id);
    }
    register(STRANGER, new ServiceID(3, 0), false);
    assertRefused(
        () -> register(STRANGER, new ServiceID(3, RegistrationRules.MAX_RESERVED_IDS), false),
        "eta");
  }

  @Test
  void anAddressHasSoManyServicesAndOthersStillMay() {
    for (int i = 0; i < RegistrationRules.MAX_SERVICES_PER_ADDRESS; i++) {
      register(STRANGER, new ServiceID(4, i), false);
    }
    assertRefused(() -> register(STRANGER, DRIVE, false), "services", "10.0.0.66", "256 allowed");
    assertRefused(() -> rules.checkService(STRANGER, null, false, USUAL), "256 allowed");
    register(STRANGER, new ServiceID(4, 7), false); // in place of its own
    register(ALLY, DRIVE, false);
    end(new ServiceID(4, 0));
    register(STRANGER, new ServiceID(4, 1000), false);
    assertRefused(() -> rules.checkService(STRANGER, null, false, USUAL), "256 allowed");
  }

  @Test
  void allOtherComputersTogetherHaveSoManyAndTheRobotAnyNumber() {
    for (int i = 0; i < RegistrationRules.MAX_FOREIGN_SERVICES; i++) {
      register(foreign(1000 + i / 100), new ServiceID(5, i), false);
    }
    assertRefused(() -> register(ALLY, DRIVE, false), "all other computers", "2048 allowed");
    for (int i = 0; i < RegistrationRules.MAX_SERVICES_PER_ADDRESS + 1; i++) {
      register(OWN, new ServiceID(6, i), true);
    }
  }

  @Test
  void listenersAreBoundedTheSameWay() {
    for (long i = 0; i < RegistrationRules.MAX_LISTENERS_PER_ADDRESS; i++) {
      listen(STRANGER, i);
    }
    assertRefused(
        () -> rules.checkListener(STRANGER, USUAL), "listeners", "10.0.0.66", "128 allowed");
    listen(ALLY, 1000);
    listen(OWN, 1001);
    assertThat(listeners.remove(5L)).isTrue();
    listen(STRANGER, 1002);
    assertRefused(() -> rules.checkListener(STRANGER, USUAL), "128 allowed");
    for (int i = 0; listeners.size() < RegistrationRules.MAX_FOREIGN_LISTENERS + 1; i++) {
      listen(foreign(2000 + i / 100), 2000 + i);
    }
    assertRefused(() -> rules.checkListener(foreign(4000), USUAL), "1024 allowed");
    rules.checkListener(OWN, USUAL);
  }

  @Test
  void oneServiceIsNoLargerThanItMayBe() {
    long most = RegistrationRules.MAX_SERVICE_BYTES;
    register(STRANGER, DRIVE, false, most);
    assertRefused(
        () -> register(STRANGER, DRIVE, false, most + 1), "services", "65537 bytes > 65536");
    rules.checkGrowth(STRANGER, DRIVE, most);
    assertRefused(() -> rules.checkGrowth(STRANGER, DRIVE, most + 1), "65537 bytes > 65536");
    register(OWN, DRIVE, true, most + 1);
    rules.checkGrowth(OWN, DRIVE, most + 1);
    assertRefused(
        () -> rules.checkListener(STRANGER, RegistrationRules.MAX_LISTENER_BYTES + 1), "listeners");
  }

  @Test
  void largeServicesAreFewerAndOthersStillMay() {
    int many = RegistrationRules.MAX_SERVICES_PER_ADDRESS / 8;
    for (int i = 0; i < many; i++) {
      register(STRANGER, new ServiceID(8, i), false, RegistrationRules.MAX_SERVICE_BYTES);
    }
    assertRefused(() -> register(STRANGER, DRIVE, false), "10.0.0.66", "bytes from that address");
    register(STRANGER, new ServiceID(8, 1), false); // in place of its own
    rules.setServiceSize(new ServiceID(8, 2), USUAL);
    register(STRANGER, DRIVE, false);
    for (int i = 0; i <= 7 * many; i++) {
      RegistrationOrigin other = foreign(3000 + i / many);
      register(other, new ServiceID(9, i), false, RegistrationRules.MAX_SERVICE_BYTES);
    }
    assertRefused(
        () -> register(ALLY, new ServiceID(1, 2), false, RegistrationRules.MAX_SERVICE_BYTES),
        "bytes from all other computers");
  }

  private void listen(RegistrationOrigin from, long event) {
    rules.checkListener(from, USUAL);
    listeners.add(event);
    rules.addListener(from, event, USUAL);
  }

  @Test
  void whatHasEndedIsNotNotedForEver() {
    for (int i = 0; i < 10_000; i++) {
      ServiceID id = new ServiceID(7, i);
      register(i % 2 == 0 ? OWN : STRANGER, id, false);
      end(id);
      listen(OWN, i);
      listeners.clear();
    }
    assertThat(rules.trackedCount()).isLessThan(200);
  }
}
