package org.dfra.sim.device;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;

/**
 * The satellites a receiver sees: always the same ones, their signals changing a little from second
 * to second.
 *
 * @param visible satellites above the horizon
 * @param channels the ones it works on
 */
record SatelliteConstellation(int visible, List<Channel> channels) {

  /** Ready for the position. */
  static final int AVAILABLE = 8;

  private static final int CODE_ACQUIRE = 1;
  private static final int[] SATELLITES = {14, 23, 24, 17, 13, 15, 22, 10, 30};
  private static final int VISIBLE = 11;

  /**
   * One channel.
   *
   * @param satellite number of the satellite
   * @param mode 0 to 8
   * @param carrierToNoise dB-Hz
   * @param ephemerisIssue issue of the ephemeris
   * @param elevation above the horizon, degrees
   * @param azimuth from true north, clockwise, degrees
   */
  record Channel(
      int satellite, int mode, int carrierToNoise, int ephemerisIssue, int elevation, int azimuth) {

    /** Whether the position may rest on it. */
    boolean isUsed() {
      return mode == AVAILABLE;
    }
  }

  /** The sky of a receiver that has found its satellites. */
  static SatelliteConstellation withFix(Instant time) {
    return of(time, SATELLITES.length);
  }

  /** The sky of a receiver that has found two satellites and looks for the others. */
  static SatelliteConstellation searching(Instant time) {
    return of(time, 2);
  }

  /** Satellites locked on, in the first so many channels. */
  int tracked(int limit) {
    return (int) channels.stream().limit(limit).filter(c -> c.mode() == AVAILABLE).count();
  }

  private static SatelliteConstellation of(Instant time, int found) {
    List<Channel> channels = new ArrayList<>();
    for (int i = 0; i < SATELLITES.length; i++) {
      int satellite = SATELLITES[i];
      boolean isFound = i < found;
      int strength = 41 + (int) Math.floorMod(time.getEpochSecond() * 3 + satellite, 9L);
      channels.add(
          new Channel(
              satellite,
              isFound ? AVAILABLE : CODE_ACQUIRE,
              isFound ? strength : 0,
              isFound ? 2 * satellite : 0,
              10 + 8 * i,
              (satellite * 37) % 360));
    }
    return new SatelliteConstellation(VISIBLE, List.copyOf(channels));
  }
}
