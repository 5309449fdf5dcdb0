package org.dfra.sim.physics;

import java.time.Instant;

/** Renders a camera's view from its mount, on the robot or on a moving head. */
@FunctionalInterface
public interface CameraInput {

  /**
   * A frame as the camera's sensor read it, noise included. Confined to the caller.
   *
   * @param width pixels
   * @param height pixels
   * @param samples row by row from the upper left: of a visible camera 0xRRGGBB, of a thermal one
   *     the temperature in hundredths of a kelvin
   */
  record Frame(int width, int height, int[] samples) {

    public Frame {
      if (samples.length != width * height) {
        throw new IllegalArgumentException(
            samples.length
                + " samples do not fill "
                + width
                + " × "
                + height
                + " pixels; give one for each pixel");
      }
    }
  }

  /** Takes a frame. */
  Frame capture(Instant time);
}
