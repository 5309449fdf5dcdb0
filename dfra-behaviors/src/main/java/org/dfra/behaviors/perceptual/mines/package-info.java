/**
 * Mine detection: detections in visible and thermal images, projected to the ground, and fused over
 * many observations of several cameras.
 *
 * <pre>
 *   CameraImage --&gt; DecodedImage --&gt; ContrastPeakFinder --&gt; ImageDetections --.
 *                   WindowGrid --------^                                      |
 *   PoseEstimate --&gt; PoseBuffer --&gt; Viewpoint --------------&gt; MineObservation &lt;
 *                                                                     |
 *   MinePercept &lt;-- MineCandidateMap (EvidenceCombination) &lt;------------'
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.perceptual.mines.MineDetectorImpl}, at {@link
 * org.dfra.behaviors.perceptual.mines.ImageMineDetector} for one image, or at {@link
 * org.dfra.behaviors.perceptual.mines.EvidenceCombination} for evidence alone.
 */
@NullMarked
package org.dfra.behaviors.perceptual.mines;

import org.jspecify.annotations.NullMarked;
