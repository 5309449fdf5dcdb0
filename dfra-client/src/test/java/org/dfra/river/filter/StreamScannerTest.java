package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.management.ThreadMXBean;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.InvalidObjectException;
import java.io.NotSerializableException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.ObjectStreamClass;
import java.io.Serializable;
import java.io.StreamCorruptedException;
import java.io.WriteAbortedException;
import java.lang.management.ManagementFactory;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.URI;
import java.time.Duration;
import java.time.Instant;
import java.time.ZonedDateTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Hashtable;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Properties;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.UUID;
import javax.security.auth.x500.X500Principal;
import net.jini.id.UuidFactory;
import net.jini.io.MarshalInputStream;
import net.jini.io.MarshalOutputStream;
import net.jini.io.MarshalledInstance;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.tcp.TcpEndpoint;
import org.assertj.core.api.AbstractThrowableAssert;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.junit.jupiter.api.Test;

class StreamScannerTest {

  /** More than a key may be. */
  private static final int MANY = 2_049;

  /** A class with all that the grammar has: primitive fields, references, data of its own. */
  private static class Parent implements Serializable {
    private static final long serialVersionUID = 1L;
    final int number;

    Parent(int number) {
      this.number = number;
    }
  }

  private static final class Child extends Parent {
    private static final long serialVersionUID = 1L;
    private final Object value;
    private final long time;

    Child(int number, Object value, long time) {
      super(number);
      this.value = value;
      this.time = time;
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Child child
          && child.value.equals(value)
          && child.time == time
          && child.number == number;
    }

    @Override
    public int hashCode() {
      return number;
    }
  }

  @Test
  void whatIsHonestPassesUnchanged() throws Exception {
    Exception failure = new IllegalStateException("x", new IOException());
    failure.addSuppressed(new ArithmeticException());
    List<Object> values =
        new ArrayList<>(
            List.of(
                "text",
                "x".repeat(70_000),
                3.5,
                'c',
                new double[361],
                new byte[200_000],
                new boolean[3],
                new String[][] {{"a", null}, {}},
                Readiness.READY,
                EnumSet.of(Readiness.READY),
                new EnumMap<>(Map.of(Readiness.READY, "yes")),
                UUID.randomUUID(),
                Instant.EPOCH,
                Duration.ofSeconds(2),
                ZonedDateTime.parse("2024-05-01T10:00:00+02:00[Europe/Berlin]"),
                List.of(),
                List.of(1, 2),
                Set.of(1, 2, 3),
                Map.of("a", List.of(1, 2)),
                new HashMap<>(Map.of("a", Map.of("b", 1))),
                new LinkedHashMap<>(Map.of(1L, 2)),
                new LinkedHashSet<>(List.of("b", "a")),
                new Hashtable<>(Map.of("a", 1)),
                new TreeMap<>(Map.of("a", "b")),
                new TreeSet<>(Set.of("a", "b")),
                new Child(1, List.of("a"), 3),
                String.class,
                new X500Principal("CN=team"),
                InetAddress.getByAddress(new byte[] {127, 0, 0, 1}),
                URI.create("http://host/"),
                new Identification("atrv1", "gps_front", "GPS", "DFRA", "1.0")));
    Properties properties = new Properties();
    properties.setProperty("a", "b");
    values.add(properties);
    values.add(Collections.nCopies(50_000, Instant.EPOCH));
    values.add(new MarshalledInstance("x"));
    for (Object value : values) {
      Object read = read(Payload.bytes(value));
      assertThat(Objects.deepEquals(read, value)).as(value.getClass().getName()).isTrue();
    }
    Object all = read(Payload.bytes(values));
    assertThat((List<?>) all).hasSize(values.size());
    assertThat(read(Payload.bytes(failure))).hasToString(failure.toString());
  }

  @Test
  void proxiesAnnotationsAndCyclesPass() throws Exception {
    Object proxy =
        Proxy.newProxyInstance(
            getClass().getClassLoader(),
            new Class<?>[] {Comparable.class, Runnable.class},
            new Nothing());
    Object[] cycle = {proxy, null, proxy};
    cycle[1] = cycle;
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new MarshalOutputStream(bytes, List.of())) {
      out.writeLong(42);
      out.writeObject(cycle);
      out.writeInt(7);
      out.writeUTF("y".repeat(2_000));
      out.reset();
      out.writeUnshared("end");
    }
    MarshalInputStream in =
        new MarshalInputStream(
            ScannedStream.of(new ByteArrayInputStream(bytes.toByteArray()), SerialLimits.CALL),
            getClass().getClassLoader(),
            false,
            null,
            List.of());
    in.useCodebaseAnnotations();
    try (in) {
      assertThat(in.readLong()).isEqualTo(42);
      Object[] read = (Object[]) in.readObject();
      assertThat(read[1]).isSameAs(read);
      assertThat(read[0]).isInstanceOf(Runnable.class).isSameAs(read[2]);
      assertThat(in.readInt()).isEqualTo(7);
      assertThat(in.readUTF()).hasSize(2_000);
      assertThat(in.readObject()).isEqualTo("end");
      assertThat(in.read()).isNegative();
    }
  }

  static final class Nothing implements java.lang.reflect.InvocationHandler, Serializable {
    private static final long serialVersionUID = 1L;

    @Override
    public Object invoke(Object proxy, java.lang.reflect.Method method, Object[] arguments) {
      throw new UnsupportedOperationException(method.getName());
    }
  }

  @Test
  void checkedBytesAreTheSameOrRefused() throws Exception {
    byte[] honest = Payload.bytes(List.of("a", Instant.EPOCH));
    assertThat(SerialFilters.checked(new ByteArrayInputStream(honest)).readAllBytes())
        .isEqualTo(honest);
    InputStream deep =
        SerialFilters.checked(new ByteArrayInputStream(Payload.bytes(Payload.nested(100))));
    assertThatThrownBy(deep::readAllBytes)
        .isInstanceOf(InvalidObjectException.class)
        .hasMessageContaining("objects nested > 24 allowed");
  }

  @Test
  void whatTheWriterCouldNotWriteIsReported() throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ObjectOutputStream out = new ObjectOutputStream(bytes);
    assertThatThrownBy(() -> out.writeObject(List.of("a", new Object())))
        .isInstanceOf(NotSerializableException.class);
    out.writeObject("after");
    out.close();
    try (ObjectInputStream in = stream(bytes.toByteArray())) {
      assertThatThrownBy(in::readObject).isInstanceOf(WriteAbortedException.class);
      assertThat(in.readObject()).isEqualTo("after");
    }
  }

  @Test
  void refusesTablesInOneAnotherThroughReferencesBack() throws Exception {
    List<Object> rungs = new ArrayList<>();
    Set<Object> below = new HashSet<>(Set.of("x"));
    rungs.add(below);
    for (int i = 0; i < 2; i++) {
      Set<Object> next = new HashSet<>();
      next.add(below);
      rungs.add(next);
      below = next;
    }
    assertThat(read(Payload.bytes(rungs.subList(0, 2).toArray()))).isNotNull();
    assertRefused(rungs.toArray()).hasMessageContaining("3 hash tables in one another > 2");
  }

  @Test
  void refusesAKeyWhoseHashCodeTakesForEver() throws Exception {
    List<Object> ladder = new ArrayList<>(List.of("x"));
    List<Object> rungs = new ArrayList<>();
    for (int i = 0; i < 16; i++) { // 2 to the 16 steps; each rung is at depth 2
      rungs.add(ladder);
      ladder = new ArrayList<>(List.of(ladder, ladder));
    }
    assertThat(read(Payload.bytes(rungs.toArray()))).as("it is no key").isNotNull();
    List<Object> key = new ArrayList<>();
    List<Object> tables = List.of(new HashSet<>(Set.of(key)), new Hashtable<>(Map.of(key, 1)));
    key.add(ladder);
    for (Object table : tables) {
      assertRefused(new Object[] {rungs, table})
          .as(table.getClass().getName())
          .hasMessageContaining(" steps to hash keys > 32768 allowed");
    }
    assertThat(read(Payload.bytes(new HashMap<>(Map.of("x", rungs)))))
        .as("a value is not hashed")
        .isNotNull();
  }

  @Test
  void refusesAKeyThatContainsItsTable() throws Exception {
    List<Object> key = new ArrayList<>();
    Set<Object> set = new HashSet<>(Set.of(key));
    key.add(set);
    assertRefused(set).hasMessageContaining(" steps to hash keys > ");
  }

  @Test
  void refusesTooManyKeysOfEachKindOfTable() throws Exception {
    Map<Integer, Integer> map = new HashMap<>();
    for (int i = 0; i < MANY; i++) {
      map.put(i, i);
    }
    for (Object table :
        List.of(
            map,
            map.keySet().stream().collect(java.util.stream.Collectors.toCollection(HashSet::new)),
            new LinkedHashMap<>(map),
            new LinkedHashSet<>(map.keySet()),
            new Hashtable<>(map),
            Map.copyOf(map),
            Set.copyOf(map.keySet()),
            new java.util.concurrent.ConcurrentHashMap<>(map))) {
      assertRefused(table)
          .as(table.getClass().getName())
          .hasMessageContaining("2049 entries of hash tables > 2048 allowed");
    }
    assertThat(read(Payload.bytes(List.copyOf(map.keySet())))).isNotNull();
  }

  @Test
  void aStreamThatStallsCostsWhatItHasSent() throws Exception {
    byte[] announced =
        Payload.array(
            "[J", ObjectStreamClass.lookupAny(long[].class).getSerialVersionUID(), 1 << 20);
    ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    assertThatThrownBy(() -> read(announced)).isInstanceOf(EOFException.class); // loads classes
    long before = thread.getThreadAllocatedBytes(Thread.currentThread().getId());
    assertThatThrownBy(() -> read(announced)).isInstanceOf(EOFException.class);
    assertThat(thread.getThreadAllocatedBytes(Thread.currentThread().getId()) - before)
        .as("bytes allocated for 8 MiB that were announced")
        .isLessThan(1 << 20);
  }

  @Test
  void refusesWhatIsTooMuch() throws Exception {
    assertRefused(Payload.nested(100)).hasMessageContaining("25 objects nested > 24 allowed");
    byte[] announced =
        Payload.array(
            "[Ljava.lang.Object;",
            ObjectStreamClass.lookupAny(Object[].class).getSerialVersionUID(),
            2 << 20);
    assertThatThrownBy(() -> read(announced))
        .hasMessageContaining(" bytes on the heap > 16777216 allowed");
    assertRefused(new long[9][1 << 17]).hasMessageContaining("bytes");
    Object[] many = new Object[200_001];
    Arrays.fill(many, 1);
    assertRefused(many).hasMessageContaining(" objects > 200000 allowed");
  }

  @Test
  void refusesReferencesWithDistributedGarbageCollection() throws Exception {
    byte[] bytes =
        Payload.bytes(
            new BasicObjectEndpoint(
                TcpEndpoint.getInstance("127.0.0.1", 1), UuidFactory.generate(), false));
    assertThat(read(bytes)).isInstanceOf(BasicObjectEndpoint.class);
    int at = 0;
    while (bytes[at] != 0x78 || bytes[at + 1] != 0x70) { // the end of the class's description
      at++;
    }
    assertThat(bytes[at + 2]).as("collected").isZero();
    bytes[at + 2] = 1;
    assertThatThrownBy(() -> read(bytes))
        .isInstanceOf(InvalidObjectException.class)
        .hasMessageContaining("distributed garbage collection");
  }

  @Test
  void whatIsNoStreamIsCorrupted() throws Exception {
    byte[] honest = Payload.bytes(new HashMap<>(Map.of("a", List.of(1))));
    for (int i = 4; i < honest.length; i++) {
      byte[] cut = Arrays.copyOf(honest, i);
      assertThatThrownBy(() -> read(cut)).as("%d bytes", i).isInstanceOf(EOFException.class);
    }
    byte[] unknown = Arrays.copyOf(honest, honest.length);
    unknown[4] = 0x6F;
    assertThatThrownBy(() -> read(unknown)).isInstanceOf(StreamCorruptedException.class);
    byte[] exceptions = new byte[150_000];
    Arrays.fill(exceptions, (byte) 0x7B); // the tag of what the writer could not write
    System.arraycopy(honest, 0, exceptions, 0, 4);
    assertThatThrownBy(() -> read(exceptions)).isInstanceOf(StreamCorruptedException.class);
    byte[] fields = Payload.bytes(new X500Principal("CN=team"));
    byte[] name = "X500Principal".getBytes(java.nio.charset.StandardCharsets.US_ASCII);
    int at = Collections.indexOfSubList(boxed(fields), boxed(name)) + name.length;
    fields[at + Long.BYTES + 2] = 1; // the number of its fields
    assertThatThrownBy(() -> read(fields))
        .isInstanceOf(StreamCorruptedException.class)
        .hasMessageContaining("X500Principal with fields");
  }

  private static List<Byte> boxed(byte[] bytes) {
    List<Byte> boxed = new ArrayList<>();
    for (byte value : bytes) {
      boxed.add(value);
    }
    return boxed;
  }

  static AbstractThrowableAssert<?, ?> assertRefused(Object graph) throws IOException {
    byte[] bytes = Payload.bytes(graph);
    return assertThatThrownBy(() -> read(bytes))
        .isInstanceOf(InvalidObjectException.class)
        .hasCauseInstanceOf(RefusedDataException.class);
  }

  private static ObjectInputStream stream(byte[] bytes) throws IOException {
    return new ObjectInputStream(
        ScannedStream.of(new ByteArrayInputStream(bytes), SerialLimits.CALL));
  }

  static Object read(byte[] bytes) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in = stream(bytes)) {
      return in.readObject();
    }
  }
}
