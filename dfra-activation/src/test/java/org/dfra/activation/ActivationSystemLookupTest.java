package org.dfra.activation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.rmi.NotBoundException;
import java.rmi.Remote;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroup;
import java.rmi.activation.ActivationSystem;
import java.rmi.registry.LocateRegistry;
import java.rmi.registry.Registry;
import java.rmi.server.UnicastRemoteObject;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** How a JVM finds its activation system. */
class ActivationSystemLookupTest {

  private static final String NAME = "java.rmi.activation.ActivationSystem";
  private static final String PORT = "java.rmi.activation.port";

  private final TestDaemon daemon = new TestDaemon();
  private final LoopbackSockets sockets = new LoopbackSockets();
  private Registry registry;
  private int port;

  @BeforeEach
  void registryOnAnyPort() throws Exception {
    FreshJvm.pretend();
    AtomicInteger bound = new AtomicInteger();
    registry =
        LocateRegistry.createRegistry(
            0,
            null,
            wanted -> {
              ServerSocket socket = new ServerSocket(wanted, 50, InetAddress.getLoopbackAddress());
              bound.set(socket.getLocalPort());
              return socket;
            });
    port = bound.get();
    System.setProperty(PORT, Integer.toString(port));
  }

  @AfterEach
  void end() throws Exception {
    System.clearProperty(PORT);
    UnicastRemoteObject.unexportObject(registry, true);
    try {
      UnicastRemoteObject.unexportObject(daemon, true);
    } catch (java.rmi.NoSuchObjectException e) {
      // Not every test exports it.
    }
    FreshJvm.pretend();
  }

  @Test
  void systemIsLookedUpAtTheConfiguredPortAndKept() throws Exception {
    Remote stub = UnicastRemoteObject.exportObject(daemon, 0, sockets, sockets);
    registry.bind(NAME, stub);
    ActivationSystem found = ActivationGroup.getSystem();
    registry.unbind(NAME);

    assertThat(found).isEqualTo(stub);
    assertThat(ActivationGroup.getSystem()).isSameAs(found);
  }

  @Test
  void missingSystemIsReportedWithTheWayOut() {
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(ActivationGroup::getSystem)
        .withMessageStartingWith(
            "No activation system is bound as "
                + NAME
                + " in the registry at port "
                + port
                + " of this host: start the activation daemon, or set the property "
                + PORT)
        .withCauseInstanceOf(NotBoundException.class);
  }

  @Test
  void objectThatIsNoSystemIsReportedTheSame() throws Exception {
    registry.bind(NAME, registry);

    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(ActivationGroup::getSystem)
        .withMessageStartingWith("No activation system is bound as ")
        .withCauseInstanceOf(ClassCastException.class);
  }

  @Test
  void systemIsSetOnce() throws Exception {
    ActivationGroup.setSystem(daemon);

    assertThat(ActivationGroup.getSystem()).isSameAs(daemon);
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> ActivationGroup.setSystem(new TestDaemon()))
        .withMessage(
            "This JVM already has an activation system:"
                + " set it before the first use of activation.");
  }
}
