package org.dfra.flow.sensor;

import java.io.Externalizable;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInput;
import java.io.ObjectOutput;
import java.io.Serial;
import java.time.DateTimeException;
import java.time.Instant;
import org.dfra.event.Reading;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * The serial form of the readings that sensors publish often: a byte for the kind and the values,
 * without a description of each field. That took three to six times as many bytes as the values,
 * and most of the time to read them.
 */
final class SensorForm implements Externalizable {

  @Serial private static final long serialVersionUID = 1;

  private static final int FIX = 1;
  private static final int SCAN = 2;
  private static final int ODOMETRY = 3;
  private static final int RATE = 4;

  private @Nullable Reading reading;

  /** For deserialization. */
  public SensorForm() {}

  private SensorForm(Reading reading) {
    this.reading = reading;
  }

  /** What is written instead of a reading; itself if it has no time. */
  static Object of(Reading reading) {
    return reading.measured() == null ? reading : new SensorForm(reading);
  }

  @Override
  public void writeExternal(ObjectOutput out) throws IOException {
    if (reading instanceof GpsFix fix) {
      begin(out, FIX, fix);
      write(out, fix);
    } else if (reading instanceof RangeScan scan) {
      begin(out, SCAN, scan);
      write(out, scan);
    } else if (reading instanceof Odometry odometry) {
      begin(out, ODOMETRY, odometry);
      write(out, odometry);
    } else if (reading instanceof AngularRate rate) {
      begin(out, RATE, rate);
      out.writeUTF(rate.frame());
      out.writeDouble(rate.rate());
    } else {
      throw new InvalidObjectException("this form is not that of " + reading);
    }
  }

  private static void begin(ObjectOutput out, int kind, Reading reading) throws IOException {
    out.writeByte(kind);
    out.writeLong(reading.measured().getEpochSecond());
    out.writeInt(reading.measured().getNano());
  }

  @Override
  public void readExternal(ObjectInput in) throws IOException, ClassNotFoundException {
    int kind = in.readByte();
    long seconds = in.readLong();
    int nanos = in.readInt();
    try {
      Instant measured = Instant.ofEpochSecond(seconds, nanos);
      reading =
          switch (kind) {
            case FIX -> fix(in, measured);
            case SCAN -> scan(in, measured);
            case ODOMETRY -> odometry(in, measured);
            case RATE -> new AngularRate(measured, in.readUTF(), in.readDouble());
            default -> throw new InvalidObjectException("a reading of the unknown kind " + kind);
          };
    } catch (IllegalArgumentException | DateTimeException e) {
      InvalidObjectException invalid = new InvalidObjectException(String.valueOf(e.getMessage()));
      invalid.initCause(e);
      throw invalid;
    }
  }

  @Serial
  private Object readResolve() throws InvalidObjectException {
    if (reading == null) {
      throw new InvalidObjectException("a reading without its values");
    }
    return reading;
  }

  private static void write(ObjectOutput out, GpsFix fix) throws IOException {
    out.writeByte(fix.mode().ordinal());
    GeoPosition position = fix.position();
    if (position != null) { // there is none if and only if the mode is NONE
      out.writeDouble(position.latitude());
      out.writeDouble(position.longitude());
      out.writeDouble(position.height());
    }
    out.writeDouble(fix.speed());
    out.writeDouble(fix.course());
    out.writeDouble(fix.dilutionOfPrecision());
    out.writeInt(fix.satellitesVisible());
    out.writeInt(fix.satellitesTracked());
  }

  private static GpsFix fix(ObjectInput in, Instant measured) throws IOException {
    int ordinal = in.readByte();
    GpsFix.Mode[] modes = GpsFix.Mode.values();
    if (ordinal < 0 || ordinal >= modes.length) {
      throw new InvalidObjectException("a fix of the unknown mode " + ordinal);
    }
    GpsFix.Mode mode = modes[ordinal];
    GeoPosition position =
        mode == GpsFix.Mode.NONE
            ? null
            : new GeoPosition(in.readDouble(), in.readDouble(), in.readDouble());
    return new GpsFix(
        mode,
        position,
        measured,
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readInt(),
        in.readInt());
  }

  /** The ranges are an array, so that a reader's limits for arrays apply. */
  private static void write(ObjectOutput out, RangeScan scan) throws IOException {
    out.writeUTF(scan.frame());
    out.writeDouble(scan.firstAngle());
    out.writeDouble(scan.angleIncrement());
    out.writeDouble(scan.duration());
    out.writeDouble(scan.minRange());
    out.writeDouble(scan.maxRange());
    out.writeObject(scan.ranges());
  }

  private static RangeScan scan(ObjectInput in, Instant measured)
      throws IOException, ClassNotFoundException {
    String frame = in.readUTF();
    double firstAngle = in.readDouble();
    double angleIncrement = in.readDouble();
    double duration = in.readDouble();
    double minRange = in.readDouble();
    double maxRange = in.readDouble();
    if (in.readObject() instanceof float[] ranges) {
      return new RangeScan(
          measured, frame, firstAngle, angleIncrement, duration, minRange, maxRange, ranges);
    }
    throw new InvalidObjectException("a scan without ranges");
  }

  private static void write(ObjectOutput out, Odometry odometry) throws IOException {
    out.writeUTF(odometry.frame());
    out.writeUTF(odometry.childFrame());
    out.writeDouble(odometry.x());
    out.writeDouble(odometry.y());
    out.writeDouble(odometry.yaw());
    out.writeDouble(odometry.speed());
    out.writeDouble(odometry.yawRate());
  }

  private static Odometry odometry(ObjectInput in, Instant measured) throws IOException {
    return new Odometry(
        measured,
        in.readUTF(),
        in.readUTF(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble());
  }
}
