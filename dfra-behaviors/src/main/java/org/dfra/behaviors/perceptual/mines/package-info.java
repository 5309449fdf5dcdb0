/**
 * Whether there is a mine at a place: found in pictures of light and of heat, laid on the ground,
 * and what many looks of several cameras say of it, put together.
 *
 * <pre>
 *   CameraImage --&gt; Picture --&gt; Finder --&gt; Glance --+
 *                   Windows (where a mine would be)   |--&gt; Look --&gt; Places --&gt; MinePercept
 *   PoseEstimate --&gt; PoseBuffer ---&gt; Viewpoint -------+        (Fusion of Evidence)
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.perceptual.mines.MineDetectorImpl}, at {@link
 * org.dfra.behaviors.perceptual.mines.ImageMineDetector} for one image, or at {@link
 * org.dfra.behaviors.perceptual.mines.Fusion} for evidence alone.
 */
@NullMarked
package org.dfra.behaviors.perceptual.mines;

import org.jspecify.annotations.NullMarked;
