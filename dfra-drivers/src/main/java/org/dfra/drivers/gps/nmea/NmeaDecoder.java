package org.dfra.drivers.gps.nmea;

import java.util.ArrayList;
import java.util.List;
import org.dfra.drivers.gps.nmea.NmeaFields.MalformedException;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gga;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gns;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gsa;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gsv;
import org.dfra.drivers.gps.nmea.NmeaSentence.Malformed;
import org.dfra.drivers.gps.nmea.NmeaSentence.Other;
import org.dfra.drivers.gps.nmea.NmeaSentence.Rmc;
import org.dfra.drivers.gps.nmea.NmeaSentence.Satellite;
import org.dfra.drivers.gps.nmea.NmeaSentence.Vtg;
import org.dfra.drivers.gps.nmea.NmeaSentence.Zda;

/**
 * Decodes intact sentences, one at a time. Never throws, whatever the content of a sentence: an
 * invalid value makes a {@link Malformed}. Confined to one thread.
 */
final class NmeaDecoder {

  /** Metres per second in a knot. */
  private static final double KNOT = 1852.0 / 3600;

  private static final int TYPE = 2; // the talker's letters come first
  private static final int ADDRESS = 5;
  private static final int CHANNELS = 12;
  private static final String[] TALKERS = talkers();

  private final NmeaFields fields = new NmeaFields();

  NmeaSentence decode(byte[] bytes, int offset, int length) {
    fields.take(bytes, offset, length);
    int at = fields.start(0);
    if (fields.length(0) != ADDRESS || bytes[at] == 'P') {
      return new Other("", fields.text(0)); // a manufacturer's own
    }
    String talker = talker(bytes[at], bytes[at + 1]);
    int type =
        bytes[at + TYPE] << 16 | (bytes[at + TYPE + 1] & 0xFF) << 8 | (bytes[at + TYPE + 2] & 0xFF);
    try {
      return switch (type) {
        case 'R' << 16 | 'M' << 8 | 'C' -> rmc(talker);
        case 'G' << 16 | 'G' << 8 | 'A' -> gga(talker);
        case 'G' << 16 | 'N' << 8 | 'S' -> gns(talker);
        case 'V' << 16 | 'T' << 8 | 'G' -> vtg(talker);
        case 'Z' << 16 | 'D' << 8 | 'A' -> zda(talker);
        case 'G' << 16 | 'S' << 8 | 'A' -> gsa(talker);
        case 'G' << 16 | 'S' << 8 | 'V' -> gsv(talker);
        default -> new Other(talker, fields.text(0).substring(TYPE));
      };
    } catch (MalformedException e) {
      return new Malformed(talker, fields.text(0).substring(TYPE), String.valueOf(e.getMessage()));
    }
  }

  private Rmc rmc(String talker) throws MalformedException {
    return new Rmc(
        talker,
        fields.time(1),
        fields.letter(2) == 'A',
        fields.angle("latitude", 3, 'S', 90),
        fields.angle("longitude", 5, 'W', 180),
        fields.number("speed (knots)", 7, 0, 2000) * KNOT,
        fields.number("course (°)", 8, 0, 360),
        fields.date(9),
        fields.letter(12));
  }

  private Gga gga(String talker) throws MalformedException {
    return new Gga(
        talker,
        fields.time(1),
        fields.angle("latitude", 2, 'S', 90),
        fields.angle("longitude", 4, 'W', 180),
        Math.max(0, fields.whole("quality", 6, 0, 9)),
        fields.whole("satellites used", 7, 0, 99),
        fields.number("dilution", 8, 0, 999),
        fields.number("altitude (m)", 9, -10_000, 100_000),
        fields.number("separation (m)", 11, -1000, 1000));
  }

  private Gns gns(String talker) throws MalformedException {
    return new Gns(
        talker,
        fields.time(1),
        fields.angle("latitude", 2, 'S', 90),
        fields.angle("longitude", 4, 'W', 180),
        fields.text(6),
        fields.whole("satellites used", 7, 0, 999),
        fields.number("dilution", 8, 0, 999),
        fields.number("altitude (m)", 9, -10_000, 100_000),
        fields.number("separation (m)", 10, -1000, 1000));
  }

  /**
   * Each number has its unit in the next field, except in the four-number sentences of old
   * receivers.
   */
  private Vtg vtg(String talker) throws MalformedException {
    boolean hasUnits = fields.letter(2) == 'T' || fields.count() > 5;
    double knots = fields.number("speed (knots)", hasUnits ? 5 : 3, 0, 2000);
    double kilometres = fields.number("speed (km/h)", hasUnits ? 7 : 4, 0, 4000);
    return new Vtg(
        talker,
        fields.number("course (°)", 1, 0, 360),
        Double.isNaN(knots) ? kilometres / 3.6 : knots * KNOT,
        hasUnits ? fields.letter(9) : ' ');
  }

  private Zda zda(String talker) throws MalformedException {
    return new Zda(talker, fields.time(1), fields.date(2, 3, 4), fields.zone(5));
  }

  private Gsa gsa(String talker) throws MalformedException {
    List<Integer> satellites = new ArrayList<>(CHANNELS);
    for (int i = 0; i < CHANNELS; i++) {
      int number = fields.whole("satellite", 3 + i, 0, 999);
      if (number > 0) {
        satellites.add(number);
      }
    }
    return new Gsa(
        talker,
        fields.whole("dimensions", 2, 1, 3),
        satellites,
        fields.number("dilution", 15, 0, 999),
        fields.number("dilution", 16, 0, 999),
        fields.number("dilution", 17, 0, 999),
        system(18));
  }

  private Gsv gsv(String talker) throws MalformedException {
    int blocks = Math.max(0, fields.count() - 4) / 4;
    List<Satellite> satellites = new ArrayList<>(blocks);
    for (int i = 0; i < blocks; i++) {
      int at = 4 + 4 * i;
      int number = fields.whole("satellite", at, 0, 999);
      if (number > 0) {
        satellites.add(
            new Satellite(
                number,
                fields.whole("elevation (°)", at + 1, 0, 90),
                fields.whole("azimuth (°)", at + 2, 0, 360),
                fields.whole("signal (dB-Hz)", at + 3, 0, 99)));
      }
    }
    // Four fields for each satellite; a single one after them is the signal.
    boolean hasSignal = fields.count() > 4 && (fields.count() - 4) % 4 == 1;
    return new Gsv(
        talker,
        Math.max(1, fields.whole("number of sentences", 1, 1, 99)),
        Math.max(1, fields.whole("sentence", 2, 1, 99)),
        Math.max(0, fields.whole("satellites in view", 3, 0, 999)),
        satellites,
        hasSignal ? system(fields.count() - 1) : -1);
  }

  /** A hexadecimal digit; −1 if it is empty. */
  private int system(int field) throws MalformedException {
    int digit = fields.isEmpty(field) ? -1 : Character.digit(fields.letter(field), 16);
    if (digit < 0 && !fields.isEmpty(field)) {
      throw new MalformedException(
          "system \"" + fields.text(field) + "\" is not a hexadecimal digit");
    }
    return digit;
  }

  private static String talker(byte first, byte second) {
    boolean envelopes = first >= 'A' && first <= 'Z' && second >= 'A' && second <= 'Z';
    return envelopes
        ? TALKERS[(first - 'A') * 26 + second - 'A']
        : "" + (char) first + (char) second;
  }

  private static String[] talkers() {
    String[] all = new String[26 * 26];
    for (int i = 0; i < all.length; i++) {
      all[i] = "" + (char) ('A' + i / 26) + (char) ('A' + i % 26);
    }
    return all;
  }
}
