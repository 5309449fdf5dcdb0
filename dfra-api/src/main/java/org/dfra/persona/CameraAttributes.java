package org.dfra.persona;

import org.dfra.flow.sensor.CameraImage.Band;

/**
 * The spectral band, resolution and field of view of a camera.
 *
 * @param band visible or thermal
 * @param width pixels
 * @param height pixels
 * @param fieldOfView angle from the left edge to the right, radians
 */
public record CameraAttributes(Band band, int width, int height, double fieldOfView)
    implements Attributes {

  public CameraAttributes {
    if (width < 1 || height < 1) {
      throw new IllegalArgumentException("a camera of " + width + " × " + height + " pixels");
    }
    AttributeValidation.requirePositive("field of view", fieldOfView, "rad");
  }
}
