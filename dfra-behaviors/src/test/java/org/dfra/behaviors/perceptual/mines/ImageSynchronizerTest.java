package org.dfra.behaviors.perceptual.mines;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;
import org.junit.jupiter.api.Test;

class ImageSynchronizerTest {

  private final ImageSynchronizer<String> pairing = new ImageSynchronizer<>();

  private List<String> add(Band band, long millis) {
    CameraImage image =
        new CameraImage(
            Instant.ofEpochMilli(millis), "robot/c", band, 1, 1, 1, "image/png", new byte[0]);
    return pairing.add(image, band + " " + millis).stream()
        .map(ImageSynchronizer.TaggedImage::tag)
        .toList();
  }

  @Test
  void imagesOfOneTimeComeTogetherLightFirst() {
    assertThat(add(Band.THERMAL, 0)).as("nobody knows of a camera of light yet").hasSize(1);
    assertThat(add(Band.VISIBLE, 500)).isEmpty();
    assertThat(add(Band.THERMAL, 540)).containsExactly("VISIBLE 500", "THERMAL 540");
    assertThat(add(Band.THERMAL, 600)).isEmpty();
    assertThat(add(Band.VISIBLE, 740)).containsExactly("VISIBLE 740", "THERMAL 600");
  }

  @Test
  void imagesWhoseTimesDifferTooMuchWaitForNearerOnes() {
    var unused = add(Band.THERMAL, 0);
    assertThat(add(Band.VISIBLE, 500)).isEmpty();
    assertThat(add(Band.THERMAL, 700)).isEmpty();
    assertThat(add(Band.VISIBLE, 800)).containsExactly("VISIBLE 800", "THERMAL 700");
  }

  @Test
  void aCameraThatIsSilentIsNotWaitedFor() {
    var unused = add(Band.THERMAL, 0);
    assertThat(add(Band.VISIBLE, 1900)).isEmpty();
    assertThat(add(Band.VISIBLE, 2100)).containsExactly("VISIBLE 2100");
  }
}
