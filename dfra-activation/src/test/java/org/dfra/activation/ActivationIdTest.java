package org.dfra.activation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.InvalidObjectException;
import java.lang.reflect.Proxy;
import java.rmi.ConnectException;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.UnmarshalException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.Activator;
import java.rmi.activation.UnknownObjectException;
import java.rmi.registry.LocateRegistry;
import java.rmi.server.ObjID;
import java.rmi.server.RemoteObject;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.rmi.server.UID;
import java.rmi.server.UnicastRemoteObject;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Identities: equality, activation, and the serial form older peers know. */
class ActivationIdTest {

  private static final String NAME = "java.rmi.activation.ActivationID";

  /** What it answers, and what it was asked. */
  private static final class Recorder implements Activator {
    private final List<Boolean> forced = new ArrayList<>();
    private MarshalledObject<? extends Remote> answer;
    private Exception failure;

    @Override
    public MarshalledObject<? extends Remote> activate(ActivationID id, boolean force)
        throws ActivationException, RemoteException {
      forced.add(force);
      if (failure instanceof RemoteException e) {
        throw e;
      }
      if (failure instanceof ActivationException e) {
        throw e;
      }
      return answer;
    }
  }

  private record Lamp(String name) implements Remote, java.io.Serializable {}

  private final Recorder activator = new Recorder();
  private final LoopbackSockets sockets = new LoopbackSockets();

  @AfterEach
  void unexport() throws Exception {
    try {
      UnicastRemoteObject.unexportObject(activator, true);
    } catch (java.rmi.NoSuchObjectException e) {
      // Not every test exports it.
    }
  }

  @Test
  void everyIdentityIsDifferent() {
    ActivationID id = new ActivationID(activator);

    assertThat(id).isEqualTo(id).isNotEqualTo(new ActivationID(activator)).isNotEqualTo("id");
    ActivationGroupID group = new ActivationGroupID(null);
    assertThat(group).isEqualTo(group).isNotEqualTo(new ActivationGroupID(null));
    assertThat(group).isNotEqualTo("group");
    assertThat(group.getSystem()).isNull();
  }

  @Test
  void groupIdentityIsEqualAfterARoundTrip() throws Exception {
    ActivationGroupID group = new ActivationGroupID(null);

    assertThat(Streams.roundTrip(group)).isEqualTo(group).hasSameHashCodeAs(group);
  }

  @Test
  void activationReturnsTheUnmarshalledProxy() throws Exception {
    activator.answer = new MarshalledObject<>(new Lamp("left"));

    assertThat(new ActivationID(activator).activate(true)).isEqualTo(new Lamp("left"));
    assertThat(new ActivationID(activator).activate(false)).isEqualTo(new Lamp("left"));
    assertThat(activator.forced).containsExactly(true, false);
  }

  @Test
  void failuresOfTheActivatorReachTheCaller() {
    ActivationID id = new ActivationID(activator);
    for (Exception failure :
        List.of(new UnknownObjectException("who?"), new ConnectException("down"))) {
      activator.failure = failure;
      assertThatExceptionOfType(failure.getClass())
          .isThrownBy(() -> id.activate(false))
          .isSameAs(failure);
    }
  }

  @Test
  @SuppressWarnings("unchecked")
  void proxyThatIsNotRemoteCannotBeUnmarshalled() throws Exception {
    activator.answer =
        (MarshalledObject<? extends Remote>) (MarshalledObject<?>) new MarshalledObject<>("text");

    assertThatExceptionOfType(UnmarshalException.class)
        .isThrownBy(() -> new ActivationID(activator).activate(false))
        .withMessageStartingWith(
            "The object was activated but its proxy cannot be unmarshalled here");
  }

  @Test
  void activatorMustAnswerWithAProxy() {
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> new ActivationID(activator).activate(false))
        .withMessageStartingWith("The activator answered without a proxy: ");
  }

  @Test
  void identityReadElsewhereIsEqualAndStillActivates() throws Exception {
    activator.answer = new MarshalledObject<>(new Lamp("left"));
    Activator stub = (Activator) UnicastRemoteObject.exportObject(activator, 0, sockets, sockets);
    ActivationID id = new ActivationID(stub);
    ActivationID read = (ActivationID) Streams.roundTrip(id);

    assertThat(read).isEqualTo(id).hasSameHashCodeAs(id);
    assertThat(read).isNotEqualTo(new ActivationID(stub));
    assertThat(read.activate(true)).isEqualTo(new Lamp("left"));
    assertThat(activator.forced).containsExactly(true);
  }

  @Test
  void activatorExportedInThisJvmIsWrittenAsItsStub() throws Exception {
    Activator stub = (Activator) UnicastRemoteObject.exportObject(activator, 0, sockets, sockets);

    assertThat(asOlderPeer(new ActivationID(activator)))
        .usingRecursiveComparison()
        .ignoringFields("uid")
        .isEqualTo(asOlderPeer(new ActivationID(stub)));
  }

  @Test
  void olderPeerReadsWhatIsWritten() throws Exception {
    Activator stub = (Activator) UnicastRemoteObject.exportObject(activator, 0, sockets, sockets);
    var read = asOlderPeer(new ActivationID(stub));

    assertThat(read.uid).isNotNull();
    assertThat(read.refClass).isEqualTo("UnicastRef2");
    assertThat(read.format).isEqualTo((byte) 1);
    assertThat(read.factory).isEqualTo(sockets);
    assertThat(stub.toString()).contains(read.host + ":" + read.port);
    assertThat(stub.toString()).contains(read.object.toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"UnicastRef 0", "UnicastRef2 0", "UnicastRef2 1"})
  void whatAnOlderPeerWroteIsReadAndWrittenBackTheSame(String kind) throws Exception {
    var old = olderPeers(kind.substring(0, kind.length() - 2));
    if (kind.endsWith("1")) {
      old.format = 1;
      old.factory = sockets;
    }
    ActivationID read = (ActivationID) Streams.read(asOurs(Streams.write(old)));
    assertThat(asOlderPeer(read)).usingRecursiveComparison().isEqualTo(old);
  }

  @Test
  void registrysReferenceOfTheFirstKindIsEqualAfterARoundTrip() throws Exception {
    var ref = ((RemoteObject) LocateRegistry.getRegistry("127.0.0.1", 1)).getRef();
    Activator stub =
        (Activator)
            Proxy.newProxyInstance(
                null, new Class<?>[] {Activator.class}, new RemoteObjectInvocationHandler(ref));
    ActivationID id = new ActivationID(stub);

    assertThat(Streams.roundTrip(id)).isEqualTo(id);
  }

  @Test
  void activatorNotOfJrmpIsRefusedWithTheWayOut() {
    assertThatExceptionOfType(InvalidObjectException.class)
        .isThrownBy(() -> Streams.write(new ActivationID(activator)))
        .withMessage(
            "An ActivationID can be written only with an activator exported by JRMP, not with a "
                + Recorder.class.getName()
                + ": use a subclass of ActivationID with a writeReplace method.");
    assertThatExceptionOfType(InvalidObjectException.class)
        .isThrownBy(() -> Streams.write(new ActivationID(null)))
        .withMessageContaining("not with null");
  }

  @Test
  void unknownReferencesAreRefused() throws Exception {
    var unknown = olderPeers("MulticastRef");
    assertThatExceptionOfType(InvalidObjectException.class)
        .isThrownBy(() -> Streams.read(asOurs(Streams.write(unknown))))
        .withMessage(
            "An ActivationID was read whose activator has a reference of class \"MulticastRef\":"
                + " known are UnicastRef and UnicastRef2.");
    var format = olderPeers("UnicastRef2");
    format.format = 7;
    assertThatExceptionOfType(InvalidObjectException.class)
        .isThrownBy(() -> Streams.read(asOurs(Streams.write(format))))
        .withMessageContaining("has format 7: known are 0 (without) and 1 (with a socket factory)");
    var nameless = olderPeers("UnicastRef");
    nameless.uid = null;
    assertThatExceptionOfType(InvalidObjectException.class)
        .isThrownBy(() -> Streams.read(asOurs(Streams.write(nameless))))
        .withMessage("An ActivationID was read without its unique part.");
  }

  private org.dfra.activation.oldpeer.ActivationID olderPeers(String refClass) {
    var old = new org.dfra.activation.oldpeer.ActivationID();
    old.uid = new UID();
    old.refClass = refClass;
    old.host = "127.0.0.1";
    // Nobody listens on the discard port of the tests' host; the reference is not called.
    old.port = 9;
    old.object = new ObjID(ObjID.ACTIVATOR_ID);
    return old;
  }

  private static org.dfra.activation.oldpeer.ActivationID asOlderPeer(ActivationID id)
      throws Exception {
    return (org.dfra.activation.oldpeer.ActivationID)
        Streams.readAs(
            Streams.write(id), Map.of(NAME, org.dfra.activation.oldpeer.ActivationID.class));
  }

  /** The same stream under the name of the real class. */
  private static byte[] asOurs(byte[] stream) {
    return ClassNames.replace(
        stream, org.dfra.activation.oldpeer.ActivationID.class.getName(), NAME);
  }
}
