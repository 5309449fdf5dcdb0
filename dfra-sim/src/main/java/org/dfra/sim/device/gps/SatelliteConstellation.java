package org.dfra.sim.device.gps;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;

/**
 * The satellites in a receiver's view: a fixed set whose signals vary slightly from second to
 * second.
 *
 * @param visible satellites above the horizon
 * @param channels its receiver channels
 */
record SatelliteConstellation(int visible, List<Channel> channels) {

  /** Usable for the position solution. */
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

    /** Whether the position solution may use it. */
    boolean isUsed() {
      return mode == AVAILABLE;
    }
  }

  /** The constellation of a receiver with a fix. */
  static SatelliteConstellation withFix(Instant time) {
    return of(time, SATELLITES.length);
  }

  /** The constellation of a receiver that tracks two satellites and searches for the others. */
  static SatelliteConstellation searching(Instant time) {
    return of(time, 2);
  }

  /** Tracked satellites in the first {@code count} channels. */
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
