package org.dfra.behaviors.perceptual.mines;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.TreeMap;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.DempsterShaferCombination;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.flow.sensor.CameraImage.Band;
import org.junit.jupiter.api.Test;

class MineDetectorSettingsTest {

  private final Map<String, String> parameters = new TreeMap<>();

  MineDetectorSettingsTest() {
    for (String band : new String[] {"visible", "thermal"}) {
      for (String when : new String[] {"", "_after_alarm", "_after_no_alarm"}) {
        parameters.put(band + "_true_positive" + when, "0.8");
        parameters.put(band + "_false_positive" + when, "0.1");
      }
    }
  }

  private MineDetectorSettings settings() {
    return MineDetectorSettings.of(Parameters.of("robot/mines", parameters));
  }

  @Test
  void ratesAreThoseOfTheirCameraAndOfTheLookBefore() {
    parameters.put("thermal_false_positive_after_alarm", "0.7");
    RepeatedDetectionRates heat = settings().rates().get(Band.THERMAL);
    assertThat(heat).isNotNull();
    assertThat(heat.afterAlarm().falsePositive()).isEqualTo(0.7);
    assertThat(heat.first().falsePositive()).isEqualTo(0.1);
  }

  @Test
  void ratesThatNobodyMeasuredAreAskedFor() {
    parameters.remove("visible_false_positive_after_no_alarm");
    assertThatThrownBy(this::settings)
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("visible_false_positive_after_no_alarm");
  }

  @Test
  void theRatesShownAreThoseOfTheFusionChosen() {
    parameters.put("bayes_true_positive", "0.9");
    parameters.put("dempster_shafer_true_positive", "0.95");
    assertThat(settings().truePositive()).isEqualTo(0.9);
    assertThat(settings().falsePositive()).as("not configured").isNull();
    parameters.put("fusion", "dempster-shafer");
    assertThat(settings().truePositive()).isEqualTo(0.95);
    assertThat(settings().fusion()).isInstanceOf(DempsterShaferCombination.class);
  }

  @Test
  void whatCannotBeIsRefusedByName() {
    for (Map.Entry<String, String> wrong :
        Map.of(
                "fusion", "majority",
                "visible_true_positive", "1",
                "mine_colour", "olive",
                "max_distance", "0.6",
                "prior", "0")
            .entrySet()) {
      Map<String, String> others = new TreeMap<>(parameters);
      others.put(wrong.getKey(), wrong.getValue());
      assertThatThrownBy(() -> MineDetectorSettings.of(Parameters.of("robot/mines", others)))
          .as("%s", wrong)
          .isInstanceOf(ConfigurationException.class)
          .hasMessageContaining(wrong.getKey());
    }
  }
}
