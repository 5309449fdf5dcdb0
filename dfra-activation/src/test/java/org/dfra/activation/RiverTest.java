package org.dfra.activation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.server.UnicastRemoteObject;
import net.jini.activation.ActivationGroup;
import net.jini.jrmp.JrmpExporter;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What Apache River's own classes do with this package. */
class RiverTest {

  /** What the exported object offers. */
  public interface Horn extends Remote {
    String sound() throws RemoteException;
  }

  private record HornImpl(String sound) implements Horn {}

  private final TestDaemon daemon = new TestDaemon();
  private final ActivationGroupID id = new ActivationGroupID(daemon);

  @BeforeEach
  @AfterEach
  void freshJvm() {
    FreshJvm.pretend();
  }

  private static ActivationGroupDesc desc(Class<?> group) {
    return new ActivationGroupDesc(group.getName(), null, null, null, null);
  }

  @Test
  void riversGroupIsCreatedAndTravelsAsItsJeriProxy() throws Exception {
    JeriGroup group = (JeriGroup) ActivationGroup.createGroup(id, desc(JeriGroup.class), 5);
    try {
      assertThat(daemon.calls).containsExactly("activeGroup 5");
      assertThat(java.rmi.activation.ActivationGroup.currentGroupID()).isSameAs(id);
      assertThat(new MarshalledObject<>(daemon.instantiator).get()).isEqualTo(group.proxy());
    } finally {
      group.end();
    }
    assertThat(daemon.calls).endsWith("inactiveGroup 5");
  }

  @Test
  void riverRefusesAGroupThatIsNotOfItsOwn() {
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> ActivationGroup.createGroup(id, desc(PlainGroup.class), 5))
        .withMessage("group class not subclass");
  }

  @Test
  void riversJrmpExporterMakesActivatableReferences() throws Exception {
    LoopbackSockets sockets = new LoopbackSockets();
    ActivationID identity = new ActivationID(daemon);
    JrmpExporter first = new JrmpExporter(identity, 0, sockets, sockets);
    Horn horn = (Horn) first.export(new HornImpl("honk"));
    assertThat(horn.sound()).isEqualTo("honk");
    assertThat(first.unexport(true)).isTrue();

    HornImpl next = new HornImpl("toot");
    daemon.live =
        new MarshalledObject<>(UnicastRemoteObject.exportObject(next, 0, sockets, sockets));
    try {
      assertThat(horn.sound()).isEqualTo("toot");
    } finally {
      UnicastRemoteObject.unexportObject(next, true);
    }
  }
}
