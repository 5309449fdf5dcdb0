package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.management.ThreadMXBean;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InvalidClassException;
import java.io.ObjectInputStream;
import java.io.ObjectStreamClass;
import java.lang.management.ManagementFactory;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.rmi.ServerException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.TreeMap;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.concurrent.CopyOnWriteArraySet;
import java.util.concurrent.PriorityBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.assertj.core.api.AbstractThrowableAssert;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ObjectGraphFilterTest {

  private static final long LONG_ARRAY =
      ObjectStreamClass.lookupAny(long[].class).getSerialVersionUID();
  private static final long OBJECT_ARRAY =
      ObjectStreamClass.lookupAny(Object[].class).getSerialVersionUID();

  @TempDir static Path folder;
  private Payload payload;

  @BeforeAll
  static void compile() throws IOException {
    Payload.compile(folder);
  }

  @BeforeEach
  void load() {
    payload = new Payload(folder);
    Payload.reset();
  }

  @Test
  void readsWhatModulesSend() throws Exception {
    List<Object> values =
        List.of(
            "text",
            3.5,
            new double[361],
            new String[][] {{"a"}},
            Readiness.READY,
            EnumSet.of(Readiness.READY),
            UUID.randomUUID(),
            Instant.EPOCH,
            Duration.ofSeconds(2),
            new HashMap<>(Map.of("a", List.of(1, 2))),
            new TreeMap<>(Map.of("a", "b")),
            new Identification("atrv1", "gps_front", "GPS", "DFRA", "1.0"));
    for (Object value : values) {
      assertThat(read(Payload.bytes(value))).as(value.getClass().getName()).isEqualTo(value);
    }
    Exception failure = new ServerException("x", new NoSuchFileException("a", "b", "c"));
    failure.addSuppressed(new IllegalStateException(new ArithmeticException()));
    assertThat(read(Payload.bytes(failure))).hasToString(failure.toString());
    Object many = new ArrayList<>(Collections.nCopies(50_000, Instant.EPOCH));
    assertThat(read(Payload.bytes(many))).isEqualTo(many);
    assertThat(read(Payload.bytes(Payload.nested(12)))).isNotNull();
  }

  @Test
  void refusesGadgetsBeforeAnyOfThemRuns() throws Exception {
    for (Map.Entry<String, Object> gadget : payload.gadgets().entrySet()) {
      byte[] bytes = Payload.bytes(gadget.getValue());
      Payload.reset();
      assertRefused(bytes).as(gadget.getKey()).hasMessageContaining("refused to read ");
      assertThat(Payload.ran()).as(gadget.getKey()).isFalse();
    }
  }

  @Test
  void refusesWhatIsKnownToDoHarmAlsoWhereItIsConfigured() throws Exception {
    List<String> known =
        List.of(
            "com.sun.org.apache.xalan.internal.xsltc.trax.TemplatesImpl",
            "java.rmi.server.UnicastRemoteObject",
            "javax.management.BadAttributeValueExpException",
            "javax.swing.JEditorPane");
    AllowedTypes all = new AllowedTypes(known);
    for (String name : known) {
      byte[] bytes = Payload.objectOf(name, 1);
      assertThatThrownBy(() -> read(bytes, all))
          .as(name)
          .isInstanceOf(InvalidClassException.class)
          .cause()
          .hasMessageContaining("refused to read class " + name)
          .hasMessageContaining("known to do harm");
    }
  }

  @Test
  void refusesADeclaredLengthBeforeMemoryIsTaken() throws Exception {
    byte[] longs = Payload.array("[J", LONG_ARRAY, Integer.MAX_VALUE - 8);
    byte[] objects = Payload.array("[Ljava.lang.Object;", OBJECT_ARRAY, 1 << 24);
    byte[] claims = Payload.array("[J", LONG_ARRAY, 2 << 20);
    ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    assertRefused(Payload.array("[J", LONG_ARRAY, Integer.MAX_VALUE - 8)); // loads the classes
    long before = thread.getThreadAllocatedBytes(Thread.currentThread().getId());
    assertRefused(longs)
        .hasMessageContaining("2147483639 elements in one array > 4194304 allowed")
        .hasMessageContaining("dfra.serial.array");
    assertRefused(objects).hasMessageContaining("16777216 elements in one array");
    assertRefused(claims).hasMessageContaining("16777216 bytes claimed by arrays > 8388608");
    assertThat(thread.getThreadAllocatedBytes(Thread.currentThread().getId()) - before)
        .as("bytes allocated")
        .isLessThan(1 << 20);
  }

  @Test
  void refusesArraysThatClaimTooMuchTogether() throws Exception {
    long[][] many = new long[9][1 << 17]; // 9 MiB
    assertRefused(Payload.bytes(many)).hasMessageContaining("bytes");
  }

  @Test
  void refusesDeepNesting() throws Exception {
    assertRefused(Payload.bytes(Payload.nested(100)))
        .hasMessageContaining("25 objects nested > 24 allowed")
        .hasMessageContaining("dfra.serial.depth");
  }

  @Test
  void refusesAHashBombInTime() throws Exception {
    byte[] bomb = Payload.bytes(Payload.bomb(30)); // 2 to the 30 where it is built
    long began = System.nanoTime();
    assertRefused(bomb).hasMessageContaining("3 hash tables in one another > 2 allowed");
    assertThat(System.nanoTime() - began).isLessThan(TimeUnit.SECONDS.toNanos(20));
  }

  @Test
  void refusesTooManyObjects() throws Exception {
    List<Object> many = new ArrayList<>();
    for (int i = 0; i < 200_001; i++) {
      many.add(i);
    }
    assertRefused(Payload.bytes(many)).hasMessageContaining("objects > 200000 allowed");
  }

  @Test
  void tablesBesideEachOtherAreNotInOneAnother() throws Exception {
    Map<String, Map<String, Integer>> tables = new HashMap<>();
    for (int i = 0; i < 60; i++) {
      tables.put("robot " + i, new HashMap<>(Map.of("a", i, "b", -i)));
    }
    assertThat(read(Payload.bytes(tables))).isEqualTo(tables);
    Object list = List.of(tables, new HashMap<>(tables));
    assertThat(read(Payload.bytes(list))).isEqualTo(list);
    Object third = new HashMap<>(Map.of("a", tables));
    assertRefused(Payload.bytes(third)).hasMessageContaining("3 hash tables in one another");
  }

  @Test
  void refusesTablesThatAreTooLargeTogether() throws Exception {
    List<Object> tables = new ArrayList<>();
    for (int i = 0; i < 129; i++) { // the smallest has 16 places
      tables.add(new HashMap<>(Map.of(i, i)));
    }
    assertRefused(Payload.bytes(tables))
        .hasMessageContaining("2064 entries of hash tables > 2048 allowed")
        .hasMessageContaining("dfra.serial.table");
  }

  @Test
  void countsReferencesAsTheHeapDoes() throws Exception {
    assertRefused(Payload.array("[Ljava.lang.Object;", OBJECT_ARRAY, 2 << 20)) // 2 MiB if null
        .hasMessageContaining(" bytes on the heap > 16777216 allowed")
        .hasMessageContaining("dfra.serial.heap");
  }

  @Test
  void refusesCollectionsThatHashOrCompareMoreThanIsSeen() throws Exception {
    List<Map.Entry<Object, String>> instead =
        List.of(
            Map.entry(new ConcurrentHashMap<>(Map.of("a", 1)), "send a HashMap"),
            Map.entry(new ConcurrentSkipListMap<>(Map.of("a", 1)), "send a TreeMap"),
            Map.entry(new ConcurrentSkipListSet<>(List.of("a")), "send a TreeSet"),
            Map.entry(new CopyOnWriteArraySet<>(List.of("a")), "send a HashSet"),
            Map.entry(Collections.nCopies(Integer.MAX_VALUE, 1), "send an ArrayList"),
            Map.entry(new PriorityQueue<>(List.of("a")), "send an ArrayList"),
            Map.entry(new PriorityBlockingQueue<>(List.of("a")), "send an ArrayList"));
    for (Map.Entry<Object, String> each : instead) {
      assertRefused(Payload.bytes(each.getKey())).hasMessageContaining(each.getValue());
    }
  }

  @Test
  void refusesAnArrayOfAClassThatIsNotKnown() throws Exception {
    long bytes = ObjectStreamClass.lookupAny(byte[].class).getSerialVersionUID();
    assertRefused(Payload.array("[Lelsewhere.Unknown;", 1, 1))
        .hasMessageContaining("an array of a class that is not known here");
    byte[] hidden = Payload.array("[B", bytes, 1); // its codebase is refused, say
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(hidden)) {
          @Override
          protected Class<?> resolveClass(ObjectStreamClass type) throws ClassNotFoundException {
            throw new ClassNotFoundException(type.getName());
          }
        }) {
      in.setObjectInputFilter(SerialFilters.newCallFilter(new AllowedTypes(List.of())));
      assertThatThrownBy(in::readObject).hasCauseInstanceOf(RefusedDataException.class);
    }
  }

  @Test
  void allowsWhatIsConfiguredAndWhatAMethodNames() throws Exception {
    byte[] bytes = Payload.bytes(payload.object());
    for (String pattern : List.of("elsewhere.Payload", "elsewhere.*", "elsewhere.**")) {
      assertThat(read(bytes, AllowedTypes.parse(" " + pattern + ", other.** "))).isNotNull();
    }
    Class<?> type = payload.object().getClass();
    assertThat(read(bytes, new AllowedTypes(List.of()).with(List.of(type.arrayType()))))
        .isNotNull();
    for (String pattern : List.of("elsewhere", "else.**", "elsewhere.Pay", "elsewhere.sub.**")) {
      assertThatThrownBy(() -> read(bytes, AllowedTypes.parse(pattern)))
          .isInstanceOf(InvalidClassException.class);
    }
  }

  @Test
  void allowsTheNameOfAForeignInterfaceOfWhichNothingIsMade() throws Exception {
    Class<?> kind = payload.loader().loadClass("elsewhere.Payload$Kind");
    assertThat(read(Payload.bytes(kind))).isEqualTo(kind);
    assertRefused(Payload.bytes(payload.object().getClass()))
        .hasMessageContaining("refused to read class elsewhere.Payload: it is not among");
  }

  @Test
  void saysWhichConfigurationIsWrong() {
    for (String pattern : List.of("*", "**", "a..b", "com.*.x", "a b")) {
      assertThatThrownBy(() -> AllowedTypes.parse(pattern))
          .hasMessage(
              "\""
                  + pattern
                  + "\" is neither a class nor package.* nor package.**; correct"
                  + " dfra.serial.allow");
    }
    java.util.Properties wrong = new java.util.Properties();
    wrong.setProperty("dfra.serial.depth", "deep");
    assertThatThrownBy(() -> SerialLimits.CALL.with(wrong))
        .hasMessage(
            "dfra.serial.depth = \"deep\" is not a whole number above 0; correct the system"
                + " property");
  }

  private AbstractThrowableAssert<?, ?> assertRefused(byte[] bytes) {
    return assertThatThrownBy(() -> read(bytes))
        .isInstanceOf(InvalidClassException.class)
        .cause()
        .isInstanceOf(RefusedDataException.class);
  }

  private Object read(byte[] bytes) throws IOException, ClassNotFoundException {
    return read(bytes, new AllowedTypes(List.of()));
  }

  private Object read(byte[] bytes, AllowedTypes types) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes)) {
          @Override
          protected Class<?> resolveClass(ObjectStreamClass type) throws ClassNotFoundException {
            return Class.forName(type.getName(), false, payload.loader());
          }
        }) {
      in.setObjectInputFilter(SerialFilters.newCallFilter(types));
      return in.readObject();
    }
  }
}
