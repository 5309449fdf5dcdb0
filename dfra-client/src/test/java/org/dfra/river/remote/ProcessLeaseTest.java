package org.dfra.river.remote;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.jini.landlord.Landlord;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.time.Duration;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.security.proxytrust.TrustEquivalence;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Which leases one call may renew: it sends their IDs, which are secrets, to one landlord. */
class ProcessLeaseTest {

  private static final Uuid OBJECT = UuidFactory.generate();

  private static Landlord landlord(String host, int port, Uuid object) {
    return (Landlord)
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(Endpoints.tcpClient(host, port), object, false),
            Duration.ofSeconds(2),
            Landlord.class.getClassLoader(),
            Landlord.class);
  }

  private static ProcessLease lease(Landlord landlord) {
    return new ProcessLease(UuidFactory.generate(), landlord, System.currentTimeMillis() + 10_000);
  }

  /** Says that it is whatever it is compared with. */
  private record Impostor() implements InvocationHandler, TrustEquivalence {
    @Override
    public Object invoke(Object proxy, Method method, Object @Nullable [] args) {
      return method.getName().equals("equals");
    }

    @Override
    public boolean checkTrustEquivalence(Object other) {
      return true;
    }
  }

  @Test
  void onlyLeasesOfTheSameObjectAtTheSameAddress() {
    ProcessLease lease = lease(landlord("127.0.0.1", 7001, OBJECT));
    assertThat(lease.canBatch(lease(landlord("127.0.0.1", 7001, OBJECT)))).isTrue();
    assertThat(lease.canBatch(lease(landlord("127.0.0.1", 7002, OBJECT)))).isFalse();
    assertThat(lease.canBatch(lease(landlord("127.0.0.2", 7001, OBJECT)))).isFalse();
    assertThat(lease.canBatch(lease(landlord("127.0.0.1", 7001, UuidFactory.generate()))))
        .isFalse();
    assertThat(
            lease.createLeaseMap(1_000).canContainKey(lease(landlord("127.0.0.1", 7002, OBJECT))))
        .isFalse();
  }

  @Test
  void noLeaseOfALandlordThatClaimsToBeAnother() {
    Landlord impostor =
        (Landlord)
            Proxy.newProxyInstance(
                Landlord.class.getClassLoader(), new Class<?>[] {Landlord.class}, new Impostor());
    ProcessLease honest = lease(landlord("127.0.0.1", 7001, OBJECT));
    assertThat(honest.canBatch(lease(impostor))).isFalse();
    assertThat(lease(impostor).canBatch(honest)).isFalse();
  }

  @Test
  void itsIdIsNoTextAndItTravelsAsADuration() throws Exception {
    ProcessLease lease = lease(landlord("127.0.0.1", 7001, OBJECT));
    assertThat(lease.toString()).doesNotContain(lease.getReferentUuid().toString());
    ProcessLease received = copy(lease);
    assertThat(received).isEqualTo(lease).hasSameHashCodeAs(lease);
    assertThat(received.canBatch(lease)).isTrue();
    assertThat(received.getExpiration() - System.currentTimeMillis()).isBetween(1L, 10_000L);
  }

  private static ProcessLease copy(ProcessLease lease) throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(lease);
    }
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
      return (ProcessLease) in.readObject();
    }
  }

  @Test
  void refusesASerialFormWithoutALandlord() throws Exception {
    ProcessLease lease = lease(landlord("127.0.0.1", 7001, OBJECT));
    java.lang.reflect.Field field = ProcessLease.class.getDeclaredField("landlord");
    field.setAccessible(true);
    field.set(lease, null);
    assertThatThrownBy(() -> copy(lease)).isInstanceOf(InvalidObjectException.class);
  }
}
