package org.dfra.examples.mission;

/** A search by raster that can be run, in any mode. */
public interface Mission {

  /**
   * Runs it from beginning to end and cleans up.
   *
   * @param listener receives its progress, from one thread at a time
   * @return its result, whether or not the robots completed their lanes
   * @throws Exception if it could not start, or could not be monitored to its end; the message
   *     names the cause
   */
  MissionResult run(MissionProgressListener listener) throws Exception;

  /** Its mode, in one word for reports: {@code local}, {@code embedded}, {@code processes}. */
  String mode();
}
