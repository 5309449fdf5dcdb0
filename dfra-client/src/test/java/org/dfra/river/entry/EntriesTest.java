package org.dfra.river.entry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import net.jini.core.entry.Entry;
import net.jini.io.MarshalledInstance;
import net.jini.lookup.entry.Name;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.Attributes;
import org.dfra.persona.BehaviorAttributes;
import org.dfra.persona.ChainAttributes;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PersonaAttributes;
import org.dfra.persona.PoseAttributes;
import org.dfra.persona.SensorAttributes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class EntriesTest {

  private static final ModuleAttributes MODULE =
      new ModuleAttributes(
          "atrv1",
          "gps_front",
          "org.example.Driver",
          "192.0.2.1",
          "DFRA",
          "1.0",
          Readiness.READY,
          Instant.parse("2026-11-21T07:00:00.123456Z"),
          null,
          2);
  private static final ChainAttributes CHAIN = new ChainAttributes(List.of(), List.of("b", "a"));
  private static final SensorAttributes SENSOR =
      new SensorAttributes("GpsFix", List.of("m"), 0.1, 5, null, List.of("p2", "p1"));
  private static final GpsReceiverAttributes GPS =
      new GpsReceiverAttributes("M12+", "P04DC2", null, "2", 12, List.of("3D", "2D"));
  private static final PoseAttributes POSE =
      new PoseAttributes("a/gps", "a/base_link", 0.3, 0, 0.8, 0, 0, 1.5);
  private static final LocationAttributes LOCATION =
      new LocationAttributes(52.9, 6.8, 55, Instant.parse("2026-11-21T07:00:00Z"));
  private static final PersonaAttributes PERSONA =
      new PersonaAttributes("atrv1", "scout", List.of("map the field"), List.of());

  /** A device's own record, with every kind of component there is. */
  public record LaserAttributes(
      String model,
      int beams,
      Double maxRange,
      Long odometer,
      boolean outdoor,
      Readiness worst,
      Instant calibrated,
      List<String> options)
      implements Attributes {}

  private static final LaserAttributes LASER =
      new LaserAttributes(
          "LMS=200",
          361,
          81.9,
          null,
          true,
          Readiness.PAUSED,
          Instant.ofEpochMilli(123),
          List.of("a=b", "c"));

  private static final BehaviorAttributes HELD =
      new BehaviorAttributes("LegGoal", false, "PAUSED", 10, Instant.ofEpochMilli(1234));

  static Stream<List<Attributes>> sets() {
    return Stream.of(
        List.of(),
        List.of(MODULE),
        List.of(MODULE, CHAIN),
        List.of(MODULE, CHAIN, SENSOR),
        List.of(MODULE, SENSOR),
        List.of(CHAIN),
        List.of(PERSONA),
        List.of(LASER),
        List.of(MODULE, CHAIN, HELD),
        List.of(MODULE, CHAIN, SENSOR, GPS, POSE, LOCATION, PERSONA, LASER));
  }

  @ParameterizedTest
  @MethodSource("sets")
  void whatGoesOutComesBack(List<Attributes> records) {
    assertThat(Entries.toAttributes(Entries.toEntries(records)))
        .containsExactlyInAnyOrderElementsOf(records);
  }

  @Test
  void aSensorsRecordsShareOneEntryThatAlsoMatchesTemplatesForModules() {
    Entry[] entries = Entries.toEntries(List.of(CHAIN, SENSOR, MODULE, GPS));
    assertThat(entries).hasSize(2);
    assertThat(entries[0]).isInstanceOf(SensorEntry.class).isInstanceOf(ModuleEntry.class);
    assertThat(((SensorEntry) entries[0]).name).isEqualTo("gps_front");
    assertThat(((SensorEntry) entries[0]).reading).isEqualTo("GpsFix");
  }

  /** As a registrar sees it: it compares marshalled bytes. */
  @ParameterizedTest
  @MethodSource("sets")
  void equalRecordsHaveEqualBytesFieldByField(List<Attributes> records) throws Exception {
    Entry[] one = Entries.toEntries(records);
    Entry[] other = Entries.toEntries(Entries.toAttributes(one));
    for (int i = 0; i < one.length; i++) {
      for (Field field : one[i].getClass().getFields()) {
        if (!Modifier.isStatic(field.getModifiers())) {
          assertThat(new MarshalledInstance(field.get(one[i])))
              .as("%s", field)
              .isEqualTo(new MarshalledInstance(field.get(other[i])));
        }
      }
    }
  }

  @Test
  void everyEntryIsWhatJiniAsksFor() throws Exception {
    for (Class<?> kind :
        List.of(
            ModuleEntry.class,
            ChainableEntry.class,
            SensorEntry.class,
            PoseEntry.class,
            LocationEntry.class,
            GPSEntry.class,
            PersonaEntry.class,
            RecordEntry.class)) {
      assertThat(kind.getConstructor().newInstance()).isInstanceOf(Entry.class);
      for (Field field : kind.getFields()) {
        assertThat(field.getType().isPrimitive()).as("%s", field).isFalse();
      }
    }
  }

  @Test
  void whatIsNotKnownHereIsLeftOut() {
    RecordEntry strange = new RecordEntry();
    strange.type = "org.example.FromTheFuture";
    strange.values = List.of("x=1");
    RecordEntry notAttributes = new RecordEntry();
    notAttributes.type = "java.lang.Runtime";
    notAttributes.values = List.of();
    RecordEntry damaged = (RecordEntry) Entries.toEntries(List.of(LASER))[0];
    damaged.values = List.of("beams=many");
    SensorEntry half = new SensorEntry();
    half.robot = "atrv1";
    half.reading = "GpsFix";
    Entry[] entries = {
      new Name("x"), null, strange, notAttributes, damaged, half, new RecordEntry(), new GPSEntry()
    };
    assertThat(Entries.toAttributes(entries)).isEmpty();
    assertThat(Entries.toAttributes(null)).isEmpty();
  }

  /** To compute the hash code of a stranger's lists of lists could take for ever. */
  @Test
  void aRecordWhoseTextsAreNoneIsLeftOutAndNotHashed() {
    AtomicBoolean isHashed = new AtomicBoolean();
    Object list =
        new Object() {
          @Override
          public int hashCode() {
            isHashed.set(true);
            return 1;
          }
        };
    ChainableEntry entry = new ChainableEntry();
    entry.inputs = texts(list);
    entry.outputs = new ArrayList<>();
    assertThat(Entries.toAttributes(new Entry[] {entry})).isEmpty();
    assertThat(isHashed).isFalse();
    entry.inputs = texts("a");
    assertThat(Entries.toAttributes(new Entry[] {entry}))
        .containsExactly(new ChainAttributes(List.of("a"), List.of()));
  }

  @SuppressWarnings("unchecked") // nor does a stream check it
  private static List<String> texts(Object text) {
    return (List<String>) (List<?>) new ArrayList<>(List.of(text));
  }

  /** A registrar would not see which robot it names. */
  @Test
  void aModuleWithoutRobotNameOrStateIsLeftOut() {
    for (String field : List.of("robot", "name", "state")) {
      ModuleEntry entry = (ModuleEntry) Entries.toEntries(List.of(MODULE))[0];
      assertThat(Entries.toAttributes(new Entry[] {entry})).containsExactly(MODULE);
      switch (field) {
        case "robot" -> entry.robot = null;
        case "name" -> entry.name = null;
        default -> entry.state = null;
      }
      assertThat(Entries.toAttributes(new Entry[] {entry})).as("without %s", field).isEmpty();
    }
  }

  /** A policy may hide the host and others from a client, which still finds the module. */
  @Test
  void whatALookupServiceDoesNotShowIsUnknown() {
    ModuleEntry entry = (ModuleEntry) Entries.toEntries(List.of(MODULE))[0];
    entry.host = null;
    entry.driver = null;
    entry.clients = null;
    assertThat(Entries.toAttributes(new Entry[] {entry}))
        .singleElement(InstanceOfAssertFactories.type(ModuleAttributes.class))
        .satisfies(
            module -> {
              assertThat(module.path()).isEqualTo(MODULE.path());
              assertThat(module.state()).isEqualTo(MODULE.state());
              assertThat(module.host()).isEmpty();
              assertThat(module.driver()).isEmpty();
              assertThat(module.clients()).isZero();
            });
  }

  @Test
  void aRecordThatHasAnEntryIsNotReadFromAnother() {
    RecordEntry disguised = new RecordEntry();
    disguised.type = PersonaAttributes.class.getName();
    disguised.values = List.of("robot=atrv1", "role=scout");
    assertThat(Entries.toAttributes(new Entry[] {disguised})).isEmpty();
  }

  @Test
  void aRecordOfALaterReleaseIsReadWithoutWhatIsNew() {
    RecordEntry later = (RecordEntry) Entries.toEntries(List.of(LASER))[0];
    List<String> values = new ArrayList<>(List.of("news=yes"));
    values.addAll(later.values);
    later.values = values;
    assertThat(Entries.toAttributes(new Entry[] {later})).containsExactly(LASER);
  }

  @Test
  void twoRecordsOfOneTypeAreRefused() {
    assertThatThrownBy(() -> Entries.toEntries(List.of(CHAIN, CHAIN)))
        .hasMessage("there are two records of type ChainAttributes; give one");
  }

  public record OddAttributes(Thread thread) implements Attributes {}

  @Test
  void aRecordThatNoEntryCanHoldIsRefused() {
    assertThatThrownBy(() -> Entries.toEntries(List.of(new OddAttributes(new Thread()))))
        .hasMessageStartingWith("OddAttributes.thread is a Thread; an attribute is a text");
    Attributes noRecord = new Attributes() {};
    assertThatThrownBy(() -> Entries.toEntries(Arrays.asList(noRecord)))
        .hasMessageEndingWith("is not a record; attributes are records");
  }
}
