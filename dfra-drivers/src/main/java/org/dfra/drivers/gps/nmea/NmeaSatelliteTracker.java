package org.dfra.drivers.gps.nmea;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.dfra.drivers.gps.GpsReceiverProtocol.SatelliteInView;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gsa;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gsv;
import org.dfra.drivers.gps.nmea.NmeaSentence.Satellite;

/**
 * Combines the satellite data of several sentences: {@code GSV} of every system and signal, and
 * {@code GSA} of those in use. Confined to one thread.
 */
final class NmeaSatelliteTracker {

  /** Number of epochs without a report after which a system is dropped. */
  private static final int LONGEST_AGE = 30;

  private static final String SYSTEMS = "?GRECJI"; // by the numbers of NMEA 4.1

  /**
   * NMEA counts augmentation satellites from 33, which is PRN 120, and RINEX calls that one S20.
   */
  private static final int SBAS = 13;

  private record Group(List<Satellite> satellites, boolean complete, int epoch) {}

  private final Map<String, Group> groups = new TreeMap<>(); // by talker and signal
  private final List<Satellite> collected = new ArrayList<>();
  private String collecting = "";
  private int expected;
  private final Set<String> used = new HashSet<>();
  private boolean usedIsOld;
  private int epoch;

  /** Starts a new epoch. */
  void nextEpoch() {
    epoch++;
    usedIsOld = true;
    for (Iterator<Group> all = groups.values().iterator(); all.hasNext(); ) {
      if (epoch - all.next().epoch() > LONGEST_AGE) {
        all.remove();
      }
    }
  }

  /** Adds the satellites in use. */
  void take(Gsa gsa) {
    if (usedIsOld) {
      used.clear();
      usedIsOld = false;
    }
    char system =
        gsa.system() > 0 && gsa.system() < SYSTEMS.length()
            ? SYSTEMS.charAt(gsa.system())
            : systemOf(gsa.talker());
    for (int number : gsa.satellites()) {
      used.add(name(system, number));
    }
  }

  /**
   * Adds satellites in view. Where sentences of a set are lost, the last complete set is used; some
   * receivers never send a complete set.
   *
   * @return whether the satellites have changed
   */
  boolean take(Gsv gsv) {
    String key = gsv.talker() + gsv.signal();
    boolean changed = false;
    if (gsv.number() == 1) {
      changed = acceptPartial();
      collecting = key;
      expected = 1;
    }
    if (gsv.number() != expected || !collecting.equals(key)) {
      expected = 0; // one was lost: wait for the next set
      return changed;
    }
    expected++;
    collected.addAll(gsv.satellites());
    if (gsv.number() < gsv.total()) {
      return changed;
    }
    groups.put(key, new Group(List.copyOf(collected), true, epoch));
    collected.clear();
    expected = 0;
    return true;
  }

  private boolean acceptPartial() {
    Group last = groups.get(collecting);
    boolean better = !collected.isEmpty() && (last == null || !last.complete());
    if (better) {
      groups.put(collecting, new Group(List.copyOf(collected), false, epoch));
    }
    collected.clear();
    return better;
  }

  /** All satellites, sorted by name. */
  List<SatelliteInView> all() {
    Map<String, SatelliteInView> all = new TreeMap<>();
    groups.forEach(
        (key, group) -> {
          char system = systemOf(key.substring(0, 2));
          for (Satellite satellite : group.satellites()) {
            SatelliteInView seen = inView(name(system, satellite.number()), satellite);
            all.merge(seen.name(), seen, NmeaSatelliteTracker::stronger);
          }
        });
    return new ArrayList<>(all.values());
  }

  private SatelliteInView inView(String name, Satellite satellite) {
    return new SatelliteInView(
        name,
        satellite.elevation() < 0 ? null : satellite.elevation(),
        satellite.azimuth() < 0 ? null : satellite.azimuth(),
        satellite.signal() <= 0 ? null : satellite.signal(),
        used.contains(name));
  }

  /** The stronger of two signals of one satellite. */
  private static SatelliteInView stronger(SatelliteInView one, SatelliteInView other) {
    Integer first = one.signal();
    Integer second = other.signal();
    return second != null && (first == null || second > first) ? other : one;
  }

  private static char systemOf(String talker) {
    return switch (talker) {
      case "GP" -> 'G';
      case "GL" -> 'R';
      case "GA" -> 'E';
      case "GB", "BD" -> 'C';
      case "GQ", "QZ" -> 'J';
      case "GI", "IR" -> 'I';
      default -> '?'; // several systems: by their numbers
    };
  }

  private static String name(char system, int number) {
    if ((system == 'G' || system == '?') && number > 32 && number <= 64) {
      return String.format("S%02d", number - SBAS);
    }
    if ((system == 'R' || system == '?') && number > 64 && number <= 96) {
      return String.format("R%02d", number - 64);
    }
    return String.format("%c%02d", system == '?' ? 'G' : system, number);
  }
}
