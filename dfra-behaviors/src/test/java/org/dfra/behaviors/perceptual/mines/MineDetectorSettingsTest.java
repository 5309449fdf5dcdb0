package org.dfra.behaviors.perceptual.mines;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.TreeMap;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.flow.sensor.CameraImage.Band;
import org.junit.jupiter.api.Test;

class MineDetectorSettingsTest {

  private final Map<String, String> reported = new TreeMap<>();

  MineDetectorSettingsTest() {
    for (String band : new String[] {"visible", "thermal"}) {
      for (String when : new String[] {"", "_after_alarm", "_after_silence"}) {
        reported.put(band + "_true_positive" + when, "0.8");
        reported.put(band + "_false_positive" + when, "0.1");
      }
    }
  }

  private MineDetectorSettings settings() {
    return MineDetectorSettings.of(Parameters.of("robot/mines", reported));
  }

  @Test
  void ratesAreThoseOfTheirCameraAndOfTheLookBefore() {
    reported.put("thermal_false_positive_after_alarm", "0.7");
    RepeatedDetectionRates heat = settings().rates().get(Band.THERMAL);
    assertThat(heat).isNotNull();
    assertThat(heat.afterAlarm().falsePositive()).isEqualTo(0.7);
    assertThat(heat.first().falsePositive()).isEqualTo(0.1);
  }

  @Test
  void ratesThatNobodyMeasuredAreAskedFor() {
    reported.remove("visible_false_positive_after_silence");
    assertThatThrownBy(this::settings)
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("visible_false_positive_after_silence");
  }

  @Test
  void theRatesShownAreThoseOfTheFusionChosen() {
    reported.put("bayes_true_positive", "0.9");
    reported.put("dempster_shafer_true_positive", "0.95");
    assertThat(settings().truePositive()).isEqualTo(0.9);
    assertThat(settings().falsePositive()).as("not told").isNull();
    reported.put("fusion", "dempster-shafer");
    assertThat(settings().truePositive()).isEqualTo(0.95);
    assertThat(settings().fusion()).isInstanceOf(DempsterShaferFusion.class);
  }

  @Test
  void whatCannotBeIsRefusedByName() {
    for (Map.Entry<String, String> wrong :
        Map.of(
                "fusion", "majority",
                "visible_true_positive", "1",
                "mine_colour", "olive",
                "far", "0.6",
                "prior", "0")
            .entrySet()) {
      Map<String, String> others = new TreeMap<>(reported);
      others.put(wrong.getKey(), wrong.getValue());
      assertThatThrownBy(() -> MineDetectorSettings.of(Parameters.of("robot/mines", others)))
          .as("%s", wrong)
          .isInstanceOf(ConfigurationException.class)
          .hasMessageContaining(wrong.getKey());
    }
  }
}
