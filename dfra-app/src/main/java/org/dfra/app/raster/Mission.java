package org.dfra.app.raster;

/** A search by raster that can be run, in whichever way. */
public interface Mission {

  /**
   * Runs it from beginning to end and clears away what it started.
   *
   * @param listener is told how it goes on, by one thread at a time
   * @return what became of it, whether or not the robots came to the end of their lanes
   * @throws Exception if it could not begin, or could not be watched to its end; the message says
   *     why
   */
  MissionResult run(MissionListener listener) throws Exception;

  /** How it is run, in one word for reports: {@code local}, {@code embedded}, {@code processes}. */
  String mode();
}
