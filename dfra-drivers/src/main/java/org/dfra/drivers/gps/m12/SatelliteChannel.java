package org.dfra.drivers.gps.m12;

/**
 * State of one of the receiver's channels.
 *
 * @param satellite number of the satellite (SV id, PRN), 1 to 37; 0 when the channel is idle
 * @param mode tracking mode: 0 code search, 1 code acquire, 2 automatic gain, 3 preposition
 *     acquire, 4 bit sync, 5 message sync, 6 satellite time, 7 ephemeris, 8 available for position
 * @param carrierToNoise strength of the signal, dB-Hz (C/No)
 * @param ephemerisIssue issue of the ephemeris (IODE); −1 where the message does not contain it
 * @param status the channel's raw status bits: 16 bits in {@code @@Ha}, 8 in {@code @@Ea}
 */
public record SatelliteChannel(
    int satellite, int mode, int carrierToNoise, int ephemerisIssue, int status) {

  /** Whether the receiver may use this satellite for its position. */
  public boolean isAvailable() {
    return mode == 8;
  }
}
