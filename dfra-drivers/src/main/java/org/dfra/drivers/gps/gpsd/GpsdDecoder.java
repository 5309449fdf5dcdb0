package org.dfra.drivers.gps.gpsd;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import java.io.IOException;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Device;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Devices;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Malformed;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Other;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Satellite;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Sky;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Tpv;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Version;
import org.jspecify.annotations.Nullable;

/**
 * Decodes lines that {@link GpsdParser.GpsdFramer} found, one at a time. Pure; never throws,
 * whatever the content of a line: an invalid line makes a {@link Malformed}. Unknown members are
 * skipped, because every version of gpsd adds some.
 */
final class GpsdDecoder {

  private static final JsonFactory JSON =
      JsonFactory.builder()
          .streamReadConstraints(
              StreamReadConstraints.builder().maxNestingDepth(8).maxNumberLength(40).build())
          .enable(StreamReadFeature.USE_FAST_DOUBLE_PARSER)
          .disable(StreamReadFeature.INCLUDE_SOURCE_IN_LOCATION)
          .build();

  /** Represents an unknown number where numbers cannot be negative. */
  private static final int UNKNOWN = -1;

  private final JsonParser in;
  private String name = "";

  private GpsdDecoder(JsonParser in) {
    this.in = in;
  }

  /**
   * Decodes a line.
   *
   * @param bytes holds it
   * @param offset index of its first byte
   * @param length its length in bytes, with the end of the line
   */
  public static GpsdMessage decode(byte[] bytes, int offset, int length) {
    try (JsonParser in = JSON.createParser(bytes, offset, length)) {
      GpsdDecoder line = new GpsdDecoder(in);
      try {
        return line.message();
      } catch (IOException | DateTimeException e) {
        return new Malformed(line.name, firstLine(e));
      }
    } catch (IOException e) { // from closing, which reads nothing
      return new Malformed("", firstLine(e));
    }
  }

  private static String firstLine(Exception e) {
    return String.valueOf(e.getMessage()).lines().findFirst().orElse("");
  }

  private GpsdMessage message() throws IOException {
    in.nextToken();
    in.nextToken();
    name = textOf(in.nextToken());
    return switch (name) {
      case "TPV" -> position();
      case "SKY" -> sky();
      case "VERSION" -> version();
      case "DEVICES" -> devices();
      case "DEVICE" -> device();
      default -> other();
    };
  }

  /** The next member's name; null at the object's end. */
  private @Nullable String nextMember() throws IOException {
    String member = in.nextFieldName();
    if (member == null && in.currentToken() != JsonToken.END_OBJECT) {
      throw new WrongValue("an object has something else than members");
    }
    return member;
  }

  private Tpv position() throws IOException {
    String device = "";
    int mode = 0;
    int status = 0;
    Instant time = null;
    double latitude = Double.NaN;
    double longitude = Double.NaN;
    double height = Double.NaN;
    double speed = Double.NaN;
    double track = Double.NaN;
    double eph = Double.NaN;
    double epv = Double.NaN;
    for (String member = nextMember(); member != null; member = nextMember()) {
      JsonToken token = in.nextToken();
      switch (member) {
        case "device" -> device = textOf(token);
        case "mode" -> mode = whole(member, token, 0);
        case "status" -> status = Math.max(0, whole(member, token, UNKNOWN));
        case "time" -> time = Instant.parse(textOf(token));
        case "lat" -> latitude = number(member, token, -90, 90);
        case "lon" -> longitude = number(member, token, -180, 180);
        case "altHAE" -> height = number(member, token, -1e5, 1e8);
        case "speed" -> speed = number(member, token, 0, 1e5);
        case "track" -> track = number(member, token, 0, 360);
        case "eph" -> eph = number(member, token, 0, 1e9);
        case "epv" -> epv = number(member, token, 0, 1e9);
        default -> in.skipChildren();
      }
    }
    return new Tpv(device, mode, status, time, latitude, longitude, height, speed, track, eph, epv);
  }

  private Sky sky() throws IOException {
    List<Satellite> satellites = null;
    double pdop = Double.NaN;
    double hdop = Double.NaN;
    for (String member = nextMember(); member != null; member = nextMember()) {
      JsonToken token = in.nextToken();
      switch (member) {
        case "pdop" -> pdop = number(member, token, 0, 1e4);
        case "hdop" -> hdop = number(member, token, 0, 1e4);
        case "satellites" -> {
          satellites = new ArrayList<>();
          expect(JsonToken.START_ARRAY, token);
          while (in.nextToken() != JsonToken.END_ARRAY) {
            expect(JsonToken.START_OBJECT, in.currentToken());
            satellites.add(satellite());
          }
        }
        default -> in.skipChildren();
      }
    }
    return new Sky(satellites, pdop, hdop);
  }

  private Satellite satellite() throws IOException {
    int prn = -1;
    int system = -1;
    int number = -1;
    double elevation = Double.NaN;
    double azimuth = Double.NaN;
    double signal = Double.NaN;
    boolean used = false;
    for (String member = nextMember(); member != null; member = nextMember()) {
      JsonToken token = in.nextToken();
      switch (member) {
        case "PRN" -> prn = whole(member, token, UNKNOWN);
        case "gnssid" -> system = whole(member, token, UNKNOWN);
        case "svid" -> number = whole(member, token, UNKNOWN);
        case "el" -> elevation = number(member, token, -90, 90);
        case "az" -> azimuth = number(member, token, 0, 360);
        case "ss" -> signal = number(member, token, 0, 1e3);
        case "used" -> used = token == JsonToken.VALUE_TRUE;
        default -> in.skipChildren();
      }
    }
    return new Satellite(prn, system, number, elevation, azimuth, signal, used);
  }

  private Version version() throws IOException {
    String release = "";
    for (String member = nextMember(); member != null; member = nextMember()) {
      JsonToken token = in.nextToken();
      if (member.equals("release")) {
        release = textOf(token);
      } else {
        in.skipChildren();
      }
    }
    return new Version(release);
  }

  private Devices devices() throws IOException {
    List<Device> devices = new ArrayList<>();
    for (String member = nextMember(); member != null; member = nextMember()) {
      JsonToken token = in.nextToken();
      if (member.equals("devices")) {
        expect(JsonToken.START_ARRAY, token);
        while (in.nextToken() != JsonToken.END_ARRAY) {
          expect(JsonToken.START_OBJECT, in.currentToken());
          devices.add(device());
        }
      } else {
        in.skipChildren();
      }
    }
    return new Devices(devices);
  }

  private Device device() throws IOException {
    String path = "";
    String driver = "";
    String subtype = "";
    for (String member = nextMember(); member != null; member = nextMember()) {
      JsonToken token = in.nextToken();
      switch (member) {
        case "path" -> path = textOf(token);
        case "driver" -> driver = textOf(token);
        case "subtype" -> subtype = textOf(token);
        default -> in.skipChildren();
      }
    }
    return new Device(path, driver, subtype);
  }

  private Other other() throws IOException {
    while (nextMember() != null) {
      in.nextToken();
      in.skipChildren();
    }
    return new Other(name);
  }

  private String textOf(@Nullable JsonToken token) throws IOException {
    expect(JsonToken.VALUE_STRING, token);
    return in.getText();
  }

  private int whole(String member, @Nullable JsonToken token, int least) throws IOException {
    expect(JsonToken.VALUE_NUMBER_INT, token);
    long value = in.getLongValue();
    if (value < least || value > 0xFFFF) {
      throw new WrongValue(member + " " + value + " is outside " + least + " to 65535");
    }
    return (int) value;
  }

  /** NaN where it is unknown, for which some drivers of gpsd write −1. */
  private double number(String member, @Nullable JsonToken token, double least, double most)
      throws IOException {
    if (token != JsonToken.VALUE_NUMBER_INT && token != JsonToken.VALUE_NUMBER_FLOAT) {
      throw new WrongValue(member + " is not a number");
    }
    double value = in.getDoubleValue();
    if (least == 0 && value == UNKNOWN) {
      return Double.NaN;
    }
    if (!(value >= least && value <= most)) {
      throw new WrongValue(member + " " + value + " is outside " + least + " to " + most);
    }
    return value;
  }

  private static void expect(JsonToken expected, @Nullable JsonToken token) throws WrongValue {
    if (token != expected) {
      throw new WrongValue("there is " + token + " where " + expected + " should be");
    }
  }

  /** An invalid value; never leaves the decoder. */
  private static final class WrongValue extends IOException {

    private static final long serialVersionUID = 1L;

    WrongValue(String message) {
      super(message);
    }
  }
}
