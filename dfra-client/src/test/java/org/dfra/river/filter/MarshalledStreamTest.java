package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.Serializable;
import java.rmi.MarshalledObject;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import net.jini.id.UuidFactory;
import net.jini.io.MarshalledInstance;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.tcp.TcpEndpoint;
import org.junit.jupiter.api.Test;

/** What marshalled objects hold is judged when they come, since River unpacks them by itself. */
class MarshalledStreamTest {

  @Test
  void whatIsHonestPasses() throws Exception {
    MarshalledInstance read =
        (MarshalledInstance) read(Payload.bytes(new MarshalledInstance(List.of("a", 1))));
    assertThat(read.get(false)).isEqualTo(List.of("a", 1));
    Object object = read(Payload.bytes(new MarshalledObject<>(Set.of("a"))));
    assertThat(((MarshalledObject<?>) object).get()).isEqualTo(Set.of("a"));
    for (byte[] bytes : new byte[][] {{}, {(byte) 0xAC, (byte) 0xED, 0}, {1, 2, 3, 4, 5}}) {
      assertThat(read(Payload.bytes(bytes))).isEqualTo(bytes);
    }
  }

  @Test
  void refusesAKeyWhoseHashCodeTakesForEver() throws Exception {
    for (Object marshalled :
        List.of(new MarshalledInstance(keyBomb()), new MarshalledObject<>(keyBomb()))) {
      assertRefused(Payload.bytes(new Object[] {"a", marshalled}), " steps to hash keys > ");
      assertThatThrownBy(() -> SerialFilters.check((Serializable) marshalled))
          .isInstanceOf(RefusedDataException.class)
          .hasMessageContaining(" steps to hash keys > ");
    }
    SerialFilters.check(new MarshalledInstance("honest"));
  }

  @Test
  void refusesReferencesWithDistributedGarbageCollection() throws Exception {
    byte[] bytes =
        Payload.bytes(
            new MarshalledInstance(
                new BasicObjectEndpoint(
                    TcpEndpoint.getInstance("127.0.0.1", 1), UuidFactory.generate(), false)));
    assertThat(read(bytes)).isInstanceOf(MarshalledInstance.class);
    int inner = 4;
    while (bytes[inner] != (byte) 0xAC || bytes[inner + 1] != (byte) 0xED) {
      inner++;
    }
    int at = inner;
    while (bytes[at] != 0x78 || bytes[at + 1] != 0x70) { // the end of the class's description
      at++;
    }
    assertThat(bytes[at + 2]).as("collected").isZero();
    bytes[at + 2] = 1;
    assertRefused(bytes, "distributed garbage collection");
  }

  @Test
  void refusesManyInOneAnotherAndWhatIsNoStream() throws Exception {
    Object marshalled = "a";
    for (int i = 0; i < 7; i++) {
      marshalled = new MarshalledInstance(marshalled);
    }
    assertThat(read(Payload.bytes(marshalled))).isInstanceOf(MarshalledInstance.class);
    assertRefused(
        Payload.bytes(new MarshalledInstance(marshalled)), "marshalled objects in one another");
    byte[] cut = Payload.bytes("text");
    assertRefused(
        Payload.bytes(Arrays.copyOf(cut, cut.length - 1)), "begin as an object stream are none");
  }

  /** Takes 2 to the power of 60 steps to build. */
  private static Object keyBomb() {
    List<Object> ladder = new ArrayList<>(List.of("x"));
    List<Object> rungs = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      rungs.add(ladder);
      ladder = new ArrayList<>(List.of(ladder, ladder));
    }
    List<Object> key = new ArrayList<>();
    Set<Object> set = new HashSet<>(Set.of(key));
    key.add(ladder);
    return new Object[] {rungs.toArray(), set};
  }

  private static void assertRefused(byte[] bytes, String why) {
    assertThatThrownBy(() -> read(bytes))
        .hasCauseInstanceOf(RefusedDataException.class)
        .hasMessageContaining(why);
  }

  private static Object read(byte[] bytes) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in =
        new ObjectInputStream(
            ScannedStream.of(new ByteArrayInputStream(bytes), SerialLimits.CALL))) {
      return in.readObject();
    }
  }
}
