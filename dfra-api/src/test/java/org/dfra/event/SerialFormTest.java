package org.dfra.event;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.List;
import org.dfra.event.ModuleEvent.IncidentRecorded;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.ModuleEvent.ParameterChanged;
import org.dfra.event.ModuleEvent.ReadinessChanged;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Readiness;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What deliveries and readings are written as. */
class SerialFormTest {

  private static final Instant TIME = Instant.parse("2026-11-21T12:00:00.123456789Z");
  private static final double LATITUDE = 27.950603;

  private record OtherReading(Instant measured, String text) implements Reading {}

  private static GpsFix fix() {
    return new GpsFix(
        GpsFix.Mode.FIX_3D,
        new GeoPosition(LATITUDE, -82.4572, 12.4),
        TIME,
        0.61,
        Double.NaN,
        1.8,
        11,
        9);
  }

  static List<ModuleEvent> events() {
    return List.of(
        new NewReading(fix()),
        new NewReading(new GpsFix(GpsFix.Mode.NONE, null, TIME, 0, 0, 0, 0, 0)),
        new NewReading(
            new RangeScan(
                TIME, "r/laser", -1.5, 0.01, 0.013, 0, 80, new float[] {1, Float.NaN, 3.5f})),
        new NewReading(new Odometry(TIME, "r/odom", "r/base_link", 1, 2, 3, 4, 5)),
        new NewReading(new AngularRate(TIME, "r/gyro", -0.25)),
        new NewReading(new OtherReading(TIME, "of a module of somebody else")),
        new ReadinessChanged(Readiness.READY, Readiness.ACTIVE),
        new ParameterChanged("rate", "5"),
        new IncidentRecorded(new Incident(TIME, Incident.Kind.GAP, "nothing came")));
  }

  private static byte[] write(Object object) throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(object);
    }
    return bytes.toByteArray();
  }

  private static Object read(byte[] bytes) throws Exception {
    try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes))) {
      return in.readObject();
    }
  }

  @ParameterizedTest
  @MethodSource("events")
  void aDeliveryIsReadAsItWasWritten(ModuleEvent event) throws Exception {
    Delivery delivery = new Delivery("atrv1/gps_front", 3, 48_211, 2, TIME, event);
    assertThat(read(write(delivery))).isEqualTo(delivery);
    assertThat(read(write(List.of(delivery, delivery)))).isEqualTo(List.of(delivery, delivery));
  }

  /** Its values have 122 bytes; with a description of each field they took 837. */
  @Test
  void aFixTakesFewBytesMoreThanItsValues() throws Exception {
    byte[] bytes =
        write(new Delivery("atrv1/gps_front", 3, 48_211, 0, TIME, new NewReading(fix())));
    assertThat(bytes.length).isLessThan(260);
  }

  @Test
  void refusesValuesThatNoReadingHas() throws Exception {
    byte[] bytes = write(fix());
    int latitude = indexOf(bytes, ByteBuffer.allocate(8).putDouble(LATITUDE).array());
    ByteBuffer.wrap(bytes).putDouble(latitude, 91);
    assertThatThrownBy(() -> read(bytes))
        .isInstanceOf(InvalidObjectException.class)
        .hasMessageContaining("latitude 91.0°");

    byte[] mode = write(fix());
    mode[latitude - 1] = 17;
    assertThatThrownBy(() -> read(mode))
        .isInstanceOf(InvalidObjectException.class)
        .hasMessage("a fix of the unknown mode 17");

    byte[] kind = write(fix());
    kind[latitude - 14] = 99; // before mode, seconds and nanoseconds
    assertThatThrownBy(() -> read(kind))
        .isInstanceOf(InvalidObjectException.class)
        .hasMessage("a reading of the unknown kind 99");
  }

  @Test
  void refusesADeliveryWithANumberBelowZero() throws Exception {
    byte[] bytes = write(new Delivery("r/m", 4_711, 1, 0, TIME, new ParameterChanged("rate", "5")));
    byte[] negative = bytes.clone();
    int epoch = indexOf(bytes, ByteBuffer.allocate(8).putLong(4_711).array());
    ByteBuffer.wrap(negative).putLong(epoch, -1);
    assertThatThrownBy(() -> read(negative))
        .isInstanceOf(InvalidObjectException.class)
        .hasMessageContaining("none may be below 0");
  }

  private static int indexOf(byte[] bytes, byte[] part) {
    for (int i = 0; i + part.length <= bytes.length; i++) {
      if (java.util.Arrays.equals(bytes, i, i + part.length, part, 0, part.length)) {
        return i;
      }
    }
    return -1;
  }
}
