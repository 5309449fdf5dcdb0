package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.UnmarshalException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.util.List;
import java.util.concurrent.Callable;
import net.jini.activation.ActivatableInvocationHandler;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.core.host.FreePorts;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * River's own things, unmodified, under this phoenix.
 *
 * <p>Short: their groups are killed after or with phoenix. {@code dfra.full}: also alone before.
 */
class RiverIT {

  private static final boolean FULL = Boolean.getBoolean("dfra.full");

  @TempDir static Path temp;
  private static PhoenixFixture phoenix;

  @BeforeAll
  static void start() throws Exception {
    phoenix = new PhoenixFixture(temp, "restartDelay=10L").start();
  }

  @AfterAll
  static void end() {
    phoenix.close();
  }

  @Test
  void riversOwnActivationExporterAndHandlerWork() throws Exception {
    Beacon beacon = phoenix.beacon(phoenix.group("stock"), "river " + phoenix.device("s"), false);
    assertThat(java.lang.reflect.Proxy.getInvocationHandler(beacon))
        .isInstanceOf(ActivatableInvocationHandler.class);
    long next = beacon.pid();
    if (FULL) {
      long pid = next;
      PhoenixFixture.kill(pid);
      next = again(beacon::pid);
      assertThat(next).as("after kill -9 of the group").isNotEqualTo(pid);
    }
    phoenix.kill();
    phoenix.start();
    assertThat(beacon.pid()).as("after a restart of phoenix").isEqualTo(next);
    PhoenixFixture.kill(next);
    assertThat(again(beacon::pid)).as("through the proxy of a former phoenix").isNotEqualTo(next);
    beacon.deactivate();
    phoenix.awaitStatus("stock", s -> s.state() == org.dfra.river.phoenix.GroupStatus.State.IDLE);
    assertThat(beacon.pid()).as("after it became inactive").isPositive();
    phoenix.assertNoDeviceConflict();
  }

  @Test
  void stockReggieKeepsItsIdAndRegistrationsAcrossKillMinusNine() throws Exception {
    ActivationGroupID group = phoenix.group("registrar");
    Path state = Files.createDirectory(temp.resolve("registrars")).resolve("atrv1");
    int port = FreePorts.allocate();
    String[] arguments = {
      RobotBootstrap.class.getResource("registrar.config").toString(),
      "com.sun.jini.reggie.host=\"127.0.0.1\"",
      "com.sun.jini.reggie.initialUnicastDiscoveryPort=" + port,
      "com.sun.jini.reggie.persistenceDirectory=\"" + state + "\"",
      "com.sun.jini.reggie.initialMemberGroups=new String[] {}",
      "com.sun.jini.reggie.multicastInterfaces=new java.net.NetworkInterface[] {}"
    };
    ActivationID id =
        phoenix
            .system()
            .registerObject(
                new ActivationDesc(
                    group,
                    "com.sun.jini.reggie.PersistentRegistrarImpl",
                    null,
                    new MarshalledObject<>(arguments),
                    true));
    id.activate(false);
    ServiceRegistrar registrar =
        new net.jini.core.discovery.LookupLocator("127.0.0.1", port).getRegistrar();
    ServiceID registrarId = registrar.getServiceID();
    ServiceID service =
        registrar.register(new ServiceItem(null, "a service", null), 300_000).getServiceID();

    ServiceTemplate mine = new ServiceTemplate(service, null, null);
    if (FULL) { // every day StolenServiceIT kills a registrar alone
      long pid = phoenix.status("registrar").pid();
      PhoenixFixture.kill(pid);
      assertThat(again(() -> registrar.lookup(mine)))
          .as("by the same proxy")
          .isEqualTo("a service");
      assertThat(phoenix.status("registrar").pid()).isNotEqualTo(pid);
      awaitDiscovery(port, registrarId);
    }

    phoenix.kill();
    PhoenixFixture.kill(phoenix.vms("registrar").get(0));
    phoenix.start();
    assertThat(again(() -> registrar.lookup(mine)))
        .as("after both were killed")
        .isEqualTo("a service");
    assertThat(registrar.getServiceID()).isEqualTo(registrarId);
    awaitDiscovery(port, registrarId);
    assertThat(List.of(phoenix.vms("registrar"))).hasSize(1);
  }

  private static void awaitDiscovery(int port, ServiceID registrarId) {
    await("unicast discovery after the kill")
        .atMost(PhoenixFixture.PATIENCE)
        .ignoreExceptions()
        .untilAsserted(
            () ->
                assertThat(
                        new net.jini.core.discovery.LookupLocator("127.0.0.1", port)
                            .getRegistrar()
                            .getServiceID())
                    .isEqualTo(registrarId));
  }

  /**
   * A call after a kill. The client may still take the connection for good and send on it: such a
   * call may have run, so it is not River's to repeat, but the caller's.
   */
  private static <T> T again(Callable<T> call) throws Exception {
    try {
      return call.call();
    } catch (UnmarshalException e) {
      return call.call();
    }
  }
}
