"use strict";(()=>{var Ni=n=>[n[0],n[1],n[2]],$e=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Do=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],os=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],ce=(n,t,e=1)=>[n[0]+e*t[0],n[1]+e*t[1],n[2]+e*t[2]],ui=(n,t)=>[n[0]*t,n[1]*t,n[2]*t],Ir=n=>Math.hypot(n[0],n[1],n[2]);function Ha(n,t=[0,0,1]){let e=Ir(n);return e>0?ui(n,1/e):t}var I_=3,nu=[["ArrowLeft","ArrowRight","ArrowUp","ArrowDown","Home","End"],["KeyA","KeyD","KeyW","KeyS","KeyQ","KeyE"],["KeyJ","KeyL","KeyI","KeyK","KeyU","KeyO"]],Ga=class{constructor(t,e,i){this.session=t,this.camera=e,this.shortcuts=i,this.held=new Set,this.moving=new Map,addEventListener("keydown",s=>this.press(s)),addEventListener("keyup",s=>this.lift(s.code)),addEventListener("blur",()=>this.releaseAll()),document.addEventListener("visibilitychange",()=>{document.hidden&&this.releaseAll()}),document.addEventListener("click",L_),t.on("connection",()=>this.forget())}press(t){if(t.ctrlKey||t.metaKey||t.altKey||N_(t))return;let e=nu.findIndex(s=>s.includes(t.code));if(e>=0&&this.anchor(e)!==null&&this.session.can("move")){if(t.preventDefault(),t.repeat||this.held.has(t.code))return;this.held.add(t.code),this.sendHand(e);return}let i=this.shortcuts[t.key.toLowerCase()];i&&(t.key===" "&&D_(t.target)||(t.preventDefault(),(!t.repeat||t.key===".")&&i()))}lift(t){this.held.delete(t)&&this.sendHand(nu.findIndex(e=>e.includes(t)))}releaseAll(){this.held.clear();for(let t of[...this.moving.keys()])this.sendHand(t)}forget(){this.held.clear(),this.moving.clear()}anchor(t){let e=this.session.layout?.variants[0].anchors??[],i=this.session.frame?.parts[0];return e.filter((r,o)=>!i||i.anchors[10*o+9]>.5)[t]?.name??null}sendHand(t){let e=nu[t].map(m=>this.held.has(m)?1:0),i=this.moving.get(t)??this.anchor(t);if(i===null)return;let[s,r,o,a,l,c]=e,{camera:h}=this,d=ui(h.first,r-s);d=ce(d,h.up,o-a),d=ce(d,h.second,l-c);let u=Ir(d),f=u>0?ui(d,I_/u):[0,0,0];u>0?this.moving.set(t,i):this.moving.delete(t),this.session.send({type:"move",anchor:i,velocity:f})}};function L_(n){let{target:t}=n;if(n.detail===0||!(t instanceof Element))return;t instanceof HTMLInputElement&&["range","checkbox"].includes(t.type)?t.blur():t.closest("button")?.blur()}function N_({target:n,code:t}){return n instanceof HTMLElement?n instanceof HTMLInputElement?n.type==="range"?/^(Arrow|Page|Home|End)/.test(t):!["checkbox","radio","button"].includes(n.type):n.isContentEditable||["SELECT","TEXTAREA"].includes(n.tagName):!1}function D_(n){return n instanceof HTMLElement&&n.closest("button, summary, [role=menuitem]")!==null}var Wa=n=>new DataView(n).getUint32(4,!0),Hf=n=>new DataView(n).getUint32(8,!0);function Lr(n,t){let e=new DataView(n);if(e.byteLength<48||e.getUint32(0,!0)!==1179670354)throw new Error("not a frame");if(e.getUint32(4,!0)!==t.layout)throw new Error("a frame of another layout");if(n.byteLength<t.bytes)throw new Error("a frame cut short");return{layout:t.layout,number:e.getUint32(8,!0),flags:e.getUint32(12,!0),time:e.getFloat64(16,!0),steps:e.getFloat64(24,!0),realtime:e.getFloat32(32,!0),speed:e.getFloat32(36,!0),load:e.getFloat32(40,!0),parts:t.variants.map((i,s)=>F_(n,t,i,s))}}function Gf(n){n.parts[0]?.scalars.buffer?.transfer?.(0)}function F_(n,t,e,i){let{offsets:s,nodes:r,anchors:o}=e,a=t.variants[i+1]?.offsets.scalars??t.bytes;return{scalars:new Float32Array(n,s.scalars,t.scalars.length),positions:new Float32Array(n,s.positions,3*r),tension:new Uint16Array(n,s.tension,r),speed:new Uint16Array(n,s.speed,r),anchors:new Float32Array(n,s.anchors,10*o.length),grabs:new Float32Array(n,s.grabs,8*Math.floor((a-s.grabs)/32))}}function Yi(n,t,e){let i=n.scalars.indexOf(e);return i<0?NaN:t.scalars[i]}function Xa(n,t,e){let i=Yi(n,t,"tension_low"),s=Yi(n,t,"tension_high");return i+t.tension[e]/65535*(s-i)}var Fo=class{constructor(){this.low=0,this.high=1,this.fresh=!0}follow(t,e,i){if(!Number.isFinite(t)||!Number.isFinite(e))return;let s=t<-.01*e?t:0,r=Math.max(e,s+1e-9);if(this.fresh){[this.low,this.high,this.fresh]=[s,r,!1];return}let o=1-Math.exp(-i/4);this.high=r>this.high?r:this.high+o*(Math.max(r,1e-9)-this.high),this.low=s<this.low?s:this.low+o*(s-this.low)}},Wf=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"]],U_=new Set(["N","J","W","s","Hz","N/m","m","m/s","N s/m"]),Nr=n=>n==="1"?"":n.replace(/\^2/g,"²").replace(/\^3/g,"³");function Ve(n,t=""){if(n==null||Number.isNaN(n))return"–";if(!Number.isFinite(n))return n>0?"∞":"−∞";let e=t&&t!=="1"?` ${Nr(t)}`:"";if(n===0)return`0${e}`;let i=Math.abs(n);if(U_.has(t)&&(i>=1e4||i<.1)&&i>=1e-9){let s=t==="m"||t==="m/s"?1:1e10,[r,o]=Wf.find(([a])=>i>=a*.9995&&a<=s)??Wf[6];return`${Fe(n/r)} ${o}${t}`}return`${Fe(n)}${e}`}function Fe(n){let t=Math.abs(n);if(t>=1e5||t<.001){if(n===0)return"0";let[i,s]=n.toExponential(2).split("e");return`${Number(i)}e${Number(s)}`.replace("-","−")}let e=Math.max(0,2-Math.floor(Math.log10(t)));return String(Number(n.toFixed(Math.min(6,e)))).replace("-","−")}function Xf(n){let t=10**Math.floor(Math.log10(n)),e=n/t;return t*(e<1.5?1:e<3.5?2:e<7.5?5:10)}function Uo(n,t,e,i){return O_(n,t,e,i*1.3)??k_(n,t,e,i)}function O_(n,t,e,i){let{layout:s,frame:r}=n.session;if(!s||!r)return null;let o=null,a=i,l=0;return s.variants.forEach((c,h)=>{c.anchors.forEach((d,u)=>{let f=Ni(n.anchors.shown.subarray(l,l+3));if(l+=3,r.parts[h].anchors[10*u+9]<.5)return;let[m,v,g]=n.camera.project(...f),p=Math.hypot(m-t,v-e);if(g<=0||p>=a)return;a=p;let y=Math.min(d.index,c.nodes-2);o={kind:"anchor",variant:h,anchor:d.name,node:d.index,segment:y,place:f}})}),o}function k_(n,t,e,i){let{layout:s}=n.session;if(!s)return null;let{shown:r}=n.nodes,o=null,a=i;return s.variants.forEach((l,c)=>{for(let h of l.ropes){let[d,u,f]=[0,0,!0];for(let m=h.first;m<h.first+h.nodes;m++){let v=4*(n.starts[c]+m),[g,p,y]=n.camera.project(r[v],r[v+1],r[v+2]);if(m>h.first&&!f&&y>0){let[T,M]=B_(t,e,d,u,g,p);if(T<a){a=T;let R=M>.5?m:m-1,A=4*(n.starts[c]+R),_=Ni(r.subarray(A,A+3));o={kind:"node",variant:c,rope:h.name,node:R,segment:m-1,place:_}}}[d,u,f]=[g,p,y<=0]}}}),o}function Oo(n,t){let e=n.session.layout?.variants[t.variant];if(!e||t.node>=e.nodes)return null;let i=4*(n.starts[t.variant]+t.node);return Ni(n.nodes.shown.subarray(i,i+3))}function B_(n,t,e,i,s,r){let[o,a]=[s-e,r-i],l=o*o+a*a,c=l>0?Math.min(1,Math.max(0,((n-e)*o+(t-i)*a)/l)):0;return[Math.hypot(n-e-c*o,t-i-c*a),c]}var z_=8,V_=40;function H_(n,t){let[e]=n.variants,{anchors:i}=t.parts[0],s=new Map(e.anchors.filter((a,l)=>i[10*l+9]>.5).map(a=>[a.index,a.name])),r=e.loads.map(({index:a})=>a),o=e.ropes.length>4?0:z_;return e.ropes.flatMap(a=>{let l=a.nodes-1,c=Array.from({length:o+2},(u,f)=>Math.round(f*l/(o+1))).map(u=>a.first+u),h=[...s.keys(),...r].filter(u=>u>=a.first&&u<=a.first+l);return[...new Set([...c,...h])].sort((u,f)=>u-f).map(u=>{let f=Math.min(u,a.first+l-1),m={variant:0,node:u,segment:f,place:[0,0,0]},v=s.get(u);return v===void 0?{kind:"node",rope:a.name,...m}:{kind:"anchor",anchor:v,...m}})}).slice(0,V_)}function G_(n,t,e){let[i]=n.variants,[s]=t.parts;if(e.kind==="anchor"){let c=i.anchors.findIndex(({name:d})=>d===e.anchor),h=Math.hypot(...s.anchors.subarray(10*c+6,10*c+9));return`Anchor ${e.anchor}, force ${Ve(h,"N")}`}let r=i.ropes.find(({name:c})=>c===e.rope),o=r?`Node ${e.node-r.zero} of ${r.name}`:`Node ${e.node}`,a=i.loads.filter(({index:c})=>c===e.node).reduce((c,h)=>c+h.mass,0),l=a>0?`, load ${Ve(a,"kg")}`:"";return`${o}, tension ${Ve(Xa(n,s,e.segment),"N")}${l}`}function W_(n,t,e){let[i]=t.parts,s=n.variants[0].anchors.filter((a,l)=>i.anchors[10*l+9]>.5).length,r=s===1?"one anchor holds":`${s} anchors hold`,o=Ve(Yi(n,i,"tension_high"),"N");return`${n.scene.name}: ${e} at ${Ve(t.time,"s")}, ${r}, greatest tension ${o}.`}var $a=class{constructor(t,e,i,s){this.stage=t,this.canvas=e,this.voice=i,this.menu=s,this.at=-1,this.state="",e.setAttribute("role","slider"),e.setAttribute("aria-label","Places on the ropes"),e.setAttribute("aria-valuemin","1"),e.addEventListener("keydown",r=>this.press(r)),e.addEventListener("blur",()=>this.go(-1)),e.addEventListener("pointerdown",()=>this.go(-1));for(let r of["status","broken","frame"])t.session.on(r,()=>this.tell())}get stops(){let{layout:t,frame:e}=this.stage.session;return t&&e?H_(t,e):[]}press(t){let{stops:e}=this;if(t.key==="Tab"){let i=this.at<0&&t.shiftKey?-1:this.at+(t.shiftKey?-1:1);if(i<0||i>=e.length)return this.go(-1);t.preventDefault(),this.go(i)}else if(t.key==="Enter"&&e[this.at]){t.preventDefault();let i=Oo(this.stage,e[this.at]);if(!i)return;let[s,r]=this.stage.camera.project(...i);this.menu(e[this.at],s,r)}}go(t){let{stage:e,canvas:i}=this,{layout:s,frame:r}=e.session,{stops:o}=this,a=o[t]??null;this.at=a?t:-1,e.marks.chosen!==a&&(e.marks.dirty=!0),e.marks.chosen=a,i.setAttribute("aria-valuemax",String(o.length)),i.setAttribute("aria-valuenow",String(this.at+1));let l=a&&s&&r?G_(s,r,a):"None: Tab goes to the next";i.setAttribute("aria-valuetext",l)}tell(){let{layout:t,frame:e,status:i,broken:s}=this.stage.session;if(!t||!e)return;let r=s?"broken":i?.playing?"playing":"paused",o=`${t.scene.name} ${r}`;o!==this.state&&(this.state=o,this.voice.textContent=W_(t,e,r))}};var X_=8,$_=.05,qa=class{constructor(t,e,i){this.stage=t,this.hit=e,this.way=i,this.place=e.place,this.sent=-1/0,this.pending=0}moveTo(t,e){let{stage:i,hit:s}=this;if(this.place=i.camera.onPlane(t,e,s.place,i.axis),this.way==="kick"){let o=`${Fe(Ir(this.velocity()))} m/s`;i.marks.kick={from:s.place,to:this.place,text:o},i.marks.dirty=!0;return}let r=this.sent+X_-performance.now();r<=0?this.sendTarget():this.pending||=window.setTimeout(()=>this.sendTarget(),r)}sendTarget(){if(clearTimeout(this.pending),this.pending=0,this.over)return;this.sent=performance.now();let t=os(this.place,this.stage.shifts[this.hit.variant]),{session:e}=this.stage;this.hit.kind==="anchor"?e.send({type:"drag",anchor:this.hit.anchor,target:t}):e.send({type:"grab",node:this.hit.node,target:t})}velocity(){let{camera:t}=this.stage,e=t.pose.distance/t.focal;return ui(os(this.place,this.hit.place),$_/e)}release(t){let{session:e,marks:i}=this.stage;if(this.way==="kick"){i.kick=null,i.dirty=!0;let s=this.velocity();Ir(s)>.05&&e.tell({type:"kick",node:this.hit.node,velocity:s})}else this.hit.kind==="anchor"?(this.sendTarget(),e.send({type:"drop",anchor:this.hit.anchor})):t?this.sendTarget():e.send({type:"let_go",node:this.hit.node});this.over=!0}over=!1;get ring(){return ce(this.place,[0,0,0])}};var $f=18,q_=30,Y_=2.2,Z_=5,K_=550,J_=350,Ya=class{constructor(t,e,i){this.stage=t,this.element=e,this.actions=i,this.tool="hand",this.keep=!1,this.down=new Map,this.hands=new Map,this.near=!1,this.resting=null,this.hit=null,this.start=null,this.moved=!1,this.lastClick=0,this.longPress=0,this.menuOpened=!1,this.hovering=!1,e.addEventListener("pointerdown",s=>this.press(s)),e.addEventListener("pointermove",s=>this.move(s)),e.addEventListener("pointerrawupdate",s=>this.drag(s)),e.addEventListener("pointerup",s=>this.lift(s)),e.addEventListener("pointercancel",s=>this.lift(s)),e.addEventListener("pointerleave",()=>{this.resting=null,this.hover(null)}),t.beforeDraw.push(()=>this.look()),e.addEventListener("wheel",s=>this.wheel(s),{passive:!1}),e.addEventListener("contextmenu",s=>s.preventDefault())}at(t){let e=this.element.getBoundingClientRect();return{x:t.clientX-e.left,y:t.clientY-e.top}}reach(t){return t.pointerType==="mouse"?$f:q_}press(t){this.element.setPointerCapture(t.pointerId);let{x:e,y:i}=this.at(t);if(this.down.set(t.pointerId,{x:e,y:i}),this.stage.flight=null,this.down.size>1){clearTimeout(this.longPress);let s=this.hands.size>0?Uo(this.stage,e,i,this.reach(t)):null;if(s&&this.hold(t.pointerId,s))return;this.dropHands(!1),this.moved=!0;return}this.start={x:e,y:i,button:t.button,shift:t.shiftKey},this.moved=this.menuOpened=!1,this.hit=Uo(this.stage,e,i,this.reach(t)),this.near=!this.hit&&Uo(this.stage,e,i,Y_*this.reach(t))!==null,t.button===0&&this.hit&&!(t.ctrlKey||t.metaKey)&&this.hold(t.pointerId,this.hit),t.pointerType!=="mouse"&&(this.longPress=window.setTimeout(()=>this.openMenu(e,i),K_))}hold(t,e){let i=this.tool==="kick"?"kick":e.kind==="anchor"?"drag":"grab";return this.tool!=="hand"&&this.tool!=="kick"||i!=="kick"&&!this.stage.session.can(i)?!1:(this.hands.set(t,new qa(this.stage,e,i)),!0)}move(t){let{x:e,y:i}=this.at(t),s=this.down.get(t.pointerId);if(!s){this.resting=t.pointerType==="mouse"?{x:e,y:i}:null,this.look();return}if(this.down.size===2&&this.hands.size<2){this.pinch(t.pointerId,e,i);return}let{start:r}=this;if(!r||!this.moved&&Math.hypot(e-r.x,i-r.y)<Z_)return;this.moved=!0,clearTimeout(this.longPress);let[o,a]=[e-s.x,i-s.y];if(this.down.set(t.pointerId,{x:e,y:i}),this.menuOpened)return;let l=this.hands.get(t.pointerId);if(l)l.moveTo(e,i),this.stage.marks.hover=l.way==="kick"?null:l.ring,this.stage.marks.dirty=!0;else{if(this.hands.size)return;r.button!==0||r.shift||this.near?this.stage.camera.pan(o,a):this.stage.camera.orbit(o,a)}}drag(t){let e=this.hands.get(t.pointerId);if(!e||!this.moved||this.menuOpened)return;let{x:i,y:s}=this.at(t);e.moveTo(i,s)}lift(t){if(!this.down.delete(t.pointerId))return;clearTimeout(this.longPress);let{x:e,y:i}=this.at(t),s=this.hands.get(t.pointerId);s&&this.moved&&s.moveTo(e,i);let r=s!==void 0&&this.moved;this.dropHand(t.pointerId,t.shiftKey||this.keep,this.moved),!(this.moved||this.menuOpened||r||this.down.size)&&(t.button===2?this.openMenu(e,i):t.button===0&&this.click(t.timeStamp))}click(t){if(this.hit&&this.tool!=="hand"&&this.tool!=="kick"){this.actions.use(this.tool,this.hit);return}this.hit||(t-this.lastClick<J_&&this.letGo(),this.lastClick=t)}letGo(){this.stage.session.send({type:"let_go"})}openMenu(t,e){this.menuOpened=!0,this.dropHands(!1,!1),this.actions.menu(this.hit,t,e)}dropHand(t,e,i=!0){let s=this.hands.get(t);s&&(this.hands.delete(t),i&&s.release(e),this.hover(null))}dropHands(t,e=!0){for(let i of[...this.hands.keys()])this.dropHand(i,t,e)}look(){if(this.down.size)return;let{resting:t}=this;this.hover(t?Uo(this.stage,t.x,t.y,$f):null)}pinch(t,e,i){let s=[...this.down.entries()].find(([l])=>l!==t)?.[1],r=this.down.get(t);if(!s||!r)return;let[o,a]=[r,{x:e,y:i}].map(l=>Math.hypot(l.x-s.x,l.y-s.y));this.stage.camera.pan((e-r.x)/2,(i-r.y)/2),a>1&&this.stage.camera.zoom(o/a,(e+s.x)/2,(i+s.y)/2),this.down.set(t,{x:e,y:i})}wheel(t){t.preventDefault();let{x:e,y:i}=this.at(t),s=t.deltaMode===1?18:1;this.stage.flight=null,this.stage.camera.zoom(Math.exp(Math.max(-60,Math.min(60,t.deltaY*s))*.003),e,i)}hover(t){let{marks:e}=this.stage;t===null&&e.hover===null||(e.hover=t,e.dirty=!0,this.element.classList.toggle("over",t!==null))}};var ei=["#3b8bc4","#d9652b","#1f9e77","#c879a7","#d99a1c","#5ab4e0","#8a8f98"];var j_=[[.555,.159,276],[.628,.114,307],[.719,.116,356],[.776,.105,32],[.828,.11,60],[.915,.142,103]],Q_=[[.346,.12,275],[.475,.135,315],[.555,.14,352],[.63,.165,22],[.7,.135,48],[.765,.15,82]],qf=n=>n?1:.42,Yf=n=>n?.022:.04,tx=(n,t,e)=>{let i=e*Math.PI/180;return[n,t*Math.cos(i),t*Math.sin(i)]};function ex([n,t,e]){let i=(n+.3963377774*t+.2158037573*e)**3,s=(n-.1055613458*t-.0638541728*e)**3,r=(n-.0894841775*t-1.291485548*e)**3;return[4.0767416621*i-3.3077115913*s+.2309699292*r,-1.2684380046*i+2.6097574011*s-.3413193965*r,-.0041960863*i-.7034186147*s+1.707614701*r]}var ix=n=>{let t=Math.min(1,Math.max(0,n));return t<=.0031308?12.92*t:1.055*t**(1/2.4)-.055};function Dr(n){let t=n?j_:Q_,e=[],i=t.length-1;for(let a=0;a<=4e3;a++){let l=a/4e3*i,c=Math.min(i-1,Math.floor(l)),h=l-c,[d,u]=[t[c],t[c+1]],f=u[2]-d[2];f<-180&&(f+=360);let m=d[2]+h*f;e.push(tx(d[0]+h*(u[0]-d[0]),d[1]+h*(u[1]-d[1]),m))}let s=[0];for(let a=1;a<e.length;a++){let[l,c]=[e[a-1],e[a]];s.push(s[a-1]+Math.hypot(c[0]-l[0],c[1]-l[1],c[2]-l[2]))}let r=[],o=0;for(let a=0;a<256;a++){let l=s[s.length-1]*a/255;for(;o<s.length-1&&s[o]<l;)o++;r.push(ex(e[o]).map(ix))}return r}function Ys(n){let t=parseInt(n.slice(1),16);return[(t>>16&255)/255,(t>>8&255)/255,(t&255)/255]}function Ye(n,t=1){let[e,i,s]=[0,1,2].map(r=>Math.round(255*n[r]));return t<1?`rgba(${e}, ${i}, ${s}, ${t})`:`rgb(${e}, ${i}, ${s})`}function W(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))r!=null&&(s.startsWith("on")?i.addEventListener(s.slice(2),r):s.includes("-")||s==="role"||s==="for"?i.setAttribute(s,String(r)):s==="data"?Object.assign(i.dataset,r):Object.assign(i,{[s]:r}));for(let s of e)s&&i.append(s);return i}var Zf="http://www.w3.org/2000/svg",nx={play:"M8 5.5v13l10.5-6.5z",pause:"M8 5v14M16 5v14",step:"M6 5.5v13l9-6.5zM18.5 5v14",reset:"M5 12a7 7 0 1 0 2.3-5.2M5 4.5v4.2h4.2",fit:"M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5",hand:"M8.5 12V6.2a1.4 1.4 0 0 1 2.8 0V11M11.3 10V4.9a1.4 1.4 0 0 1 2.8 0V11M14.1 10.5V6.3a1.4 1.4 0 0 1 2.8 0V14c0 4-2 6.5-5.3 6.5-3 0-4.3-1.5-5.8-4.2L4 13.2c-.8-1.5 1.1-2.6 2.2-1.3l2.3 2.6",pin:"M9 3.5h6M10 3.5l-.6 6.2L6.5 13h11l-2.9-3.3L14 3.5M12 13v7.5",cut:"M6.5 19.5a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4zM17.5 19.5a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4zM8 15.5L16.5 4M16 15.5L7.5 4",load:"M12 3v5M12 8a1.5 1.5 0 0 0 0 0M7.5 10h9l2.5 10H5z",kick:"M4 12h13M12 6l6 6-6 6",follow:"M4 18c3-9 6 1 9-6 2-4.5 4-4 7-6",graph:"M4 4v16h16M7.5 15l3.5-5 3.5 3 5-7.5",scenes:"M4 5.5h7v5.5H4zM13.5 5.5H20v5.5h-6.5zM4 13.5h7V19H4zM13.5 13.5H20V19h-6.5z",tour:"M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18zM15.8 8.2l-2.3 5.3-5.3 2.3 2.3-5.3z",compare:"M12 3.5v17M4 6.5h5v11H4zM15 6.5h5v11h-5z",keep:"M12 4v10.5M7.5 10.5L12 15l4.5-4.5M4.5 16v3.5h15V16",help:"M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18zM9.5 9.5a2.6 2.6 0 1 1 3.6 2.4c-.8.4-1.1.9-1.1 1.8M12 16.8v.2",theme:"M12 20.5a8.5 8.5 0 1 0 0-17zM12 20.5a8.5 8.5 0 0 1 0-17",panel:"M4 7h9M17 7h3M15 5v4M4 12h3M11 12h9M9 10v4M4 17h11M19 17h1M17 15v4",close:"M6 6l12 12M18 6L6 18",down:"M6 9.5l6 6 6-6",link:"M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-1 1M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l1-1",undo:"M8.5 6L4.5 10l4 4M4.5 10h9a5.5 5.5 0 0 1 0 11h-2"};function mn(n,t=!1){let e=document.createElementNS(Zf,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true"),e.classList.add("icon"),t&&e.classList.add("solid");let i=document.createElementNS(Zf,"path");return i.setAttribute("d",nx[n]),e.append(i),e}function Di(n,t,e,i={}){let s=i.key?`${t} (${i.key})`:t;return W("button",{type:"button",title:s,"aria-label":t,onclick:e,id:i.id??"",className:i.kind??"plain"},mn(n,n==="play"),i.words&&W("span",{className:"words"},i.words))}function Fr(n,t,...e){let i=W("button",{type:"button",className:"plain close","aria-label":"Close",title:"Close"},mn("close")),s=W("dialog",{className:`window ${t}`,"aria-label":n},W("header",{},W("h2",{},n),i),...e);return i.onclick=()=>s.close(),s.addEventListener("close",()=>{document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),s.addEventListener("click",r=>{r.target===s&&s.close()}),s}function ko(n,t,e,i,s=""){n.querySelector(".popup")?.remove();let r=W("div",{className:"popup",role:"menu"},s&&W("div",{className:"popup-title"},s)),o=()=>{r.remove(),removeEventListener("pointerdown",a,!0),removeEventListener("keydown",l,!0)},a=h=>{r.contains(h.target)||o()},l=h=>{h.key==="Escape"&&o()};for(let h of i){let d=()=>{o(),h.press()};r.append(W("button",{type:"button",role:"menuitem",onclick:d,disabled:h.disabled??!1,id:h.id??""},h.label,h.hint&&W("small",{},h.hint)))}n.append(r);let c=n.getBoundingClientRect();return r.style.left=`${Math.max(4,Math.min(t,c.width-r.offsetWidth-4))}px`,r.style.top=`${Math.max(4,Math.min(e,c.height-r.offsetHeight-4))}px`,addEventListener("pointerdown",a,!0),addEventListener("keydown",l,!0),r.querySelector("button")?.focus({preventScroll:!0}),r}function su(n,t){let e=W("a",{href:n,download:t});document.body.append(e),e.click(),e.remove()}var Za=class{constructor(){this.count=0,this.start=0,this.time=new Float64Array(2*7200),this.columns=new Map}clear(){this.count=this.start=0,this.columns.clear()}add(t,e){if(this.count>0&&t<=this.last){if(t===this.last)return;this.count=this.search(t)}if(this.start+this.count===2*7200){for(let s of[this.time,...this.columns.values()])s.copyWithin(0,this.start+1);this.start=0,this.count=7199}let i=this.start+this.count;this.time[i]=t;for(let s of this.columns.values())s[i]=NaN;for(let[s,r]of e){let o=this.columns.get(s);o||(o=new Float64Array(2*7200).fill(NaN),this.columns.set(s,o)),o[i]=r}this.count++,this.count>7200&&(this.count=7200,this.start++)}get last(){return this.count?this.time[this.start+this.count-1]:NaN}get first(){return this.count?this.time[this.start]:NaN}between(t,e,i){let s=Math.max(0,this.search(t)-1),r=Math.min(this.count,this.search(e)+1),[o,a]=[this.start+s,this.start+r],l=new Float64Array(a-o).fill(NaN);return[this.time.subarray(o,a),...i.map(c=>this.columns.get(c)?.subarray(o,a)??l)]}search(t){let[e,i]=[0,this.count];for(;e<i;){let s=e+i>>1;this.time[this.start+s]<t?e=s+1:i=s}return e}};var Zi={left:46,right:10,top:8,bottom:34},Ka=class{constructor(t){this.canvas=W("canvas",{className:"phase"}),this.host=t,t.append(this.canvas)}resize(){let t=devicePixelRatio||1,{clientWidth:e,clientHeight:i}=this.host,[s,r]=[e*t,i*t].map(Math.round);(this.canvas.width!==s||this.canvas.height!==r)&&(this.canvas.width=s,this.canvas.height=r)}show(t,e,i){let s=this.canvas.getContext("2d");if(!s)return;let r=devicePixelRatio||1,[o,a]=[this.canvas.width/r,this.canvas.height/r];s.setTransform(r,0,0,r,0,0),s.clearRect(0,0,o,a);let l=[];for(let M=1;M+1<t.length;M++){let R=(e[M+1]-e[M-1])/(t[M+1]-t[M-1]);Number.isFinite(R)&&l.push([e[M],R])}let c=getComputedStyle(document.documentElement),h=c.getPropertyValue("--faint").trim();if(s.font="11px system-ui, sans-serif",s.fillStyle=h,l.length<3){s.fillText("Follow a node to see its phase plane.",12,24);return}let[d,u]=Kf(l.map(([M])=>M)),[f,m]=Kf(l.map(([,M])=>M)),v={w:o-Zi.left-Zi.right,h:a-Zi.top-Zi.bottom},g=M=>Zi.left+(M-d)/(u-d)*v.w,p=M=>Zi.top+(1-(M-f)/(m-f))*v.h;s.strokeStyle=c.getPropertyValue("--line").trim(),s.strokeRect(Zi.left,Zi.top,v.w,v.h),f<0&&m>0&&(s.beginPath(),s.moveTo(Zi.left,p(0)),s.lineTo(Zi.left+v.w,p(0)),s.stroke()),s.textAlign="right";for(let M of[f,m])s.fillText(Fe(Number(M.toPrecision(2))),Zi.left-4,p(M)+(M===f?0:9));s.textAlign="left",s.fillText(Fe(Number(d.toPrecision(3))),Zi.left,a-20),s.textAlign="right",s.fillText(Ve(Number(u.toPrecision(3)),"m"),o-Zi.right,a-20),s.textAlign="center",s.fillText("height; upward velocity in m/s",Zi.left+v.w/2,a-5),s.textAlign="left",s.strokeStyle=i,s.lineWidth=1.4,s.beginPath();for(let[M,R]of l)s.lineTo(g(M),p(R));s.stroke();let[y,T]=l[l.length-1];s.fillStyle=i,s.beginPath(),s.arc(g(y),p(T),4,0,2*Math.PI),s.fill()}};function Kf(n){let[t,e]=[1/0,-1/0];for(let s of n)t=Math.min(t,s),e=Math.max(e,s);let i=Math.max(1e-6,.06*(e-t));return[t-i,e+i]}var sx="uplot",rx="u-hz",ox="u-vt",ax="u-title",lx="u-wrap",cx="u-under",hx="u-over",ux="u-axis",Js="u-off",dx="u-select",fx="u-cursor-x",px="u-cursor-y",mx="u-cursor-pt",gx="u-legend",_x="u-live",xx="u-inline",vx="u-series",yx="u-marker",Jf="u-label",Mx="u-value",zo="width",Vo="height";var jf="bottom",Ur="left",ru="right",Su="#000",Qf=Su+"0",ou="mousemove",tp="mousedown",au="mouseup",ep="mouseenter",ip="mouseleave",np="dblclick",Sx="resize",bx="scroll",sp="change",el="dppxchange",bu="--",Gr=typeof window<"u",du=Gr?document:null,kr=Gr?window:null,wx=Gr?navigator:null,be,Ja;function fu(){let n=devicePixelRatio;be!=n&&(be=n,Ja&&mu(sp,Ja,fu),Ja=matchMedia(`(min-resolution: ${be-.001}dppx) and (max-resolution: ${be+.001}dppx)`),js(sp,Ja,fu),kr.dispatchEvent(new CustomEvent(el)))}function nn(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function pu(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function He(n,t,e){n.style[t]=e+"px"}function En(n,t,e,i){let s=du.createElement(n);return t!=null&&nn(s,t),e?.insertBefore(s,i),s}function gn(n,t){return En("div",n,t)}var rp=new WeakMap;function Wn(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=rp.get(n);r!=o&&(n.style.transform=r,rp.set(n,r),t<0||e<0||t>i||e>s?nn(n,Js):pu(n,Js))}var op=new WeakMap;function ap(n,t,e){let i=t+e,s=op.get(n);i!=s&&(op.set(n,i),n.style.background=t,n.style.borderColor=e)}var lp=new WeakMap;function cp(n,t,e,i){let s=t+""+e,r=lp.get(n);s!=r&&(lp.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var wu={passive:!0},Ex={...wu,capture:!0};function js(n,t,e,i){t.addEventListener(n,e,i?Ex:wu)}function mu(n,t,e,i){t.removeEventListener(n,e,wu)}Gr&&fu();function Tn(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:sn((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Op(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var kp=n=>n!=null,Bp=n=>n!=null&&n>0,sl=Op(kp),Tx=Op(Bp);function Ax(n,t,e,i=0,s=!1){let r=s?Tx:sl,o=s?Bp:kp;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Le,l??-Le]}function rl(n,t,e,i){let s=dp(n),r=dp(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?as:zp,a=s==1?sn:_n,l=r==1?_n:sn,c=a(o(vi(n))),h=l(o(vi(t))),d=Br(e,c),u=Br(e,h);return e==10&&(c<0&&(d=Ne(d,-c)),h<0&&(u=Ne(u,-h))),i||e==2?(n=d*s,t=u*r):(n=Wp(n,d),t=ol(t,u)),[n,t]}function Eu(n,t,e,i){let s=rl(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Tu=.1,hp={mode:3,pad:Tu},Go={pad:0,soft:null,mode:0},Rx={min:Go,max:Go};function il(n,t,e,i){return al(e)?up(n,t,e):(Go.pad=e,Go.soft=i?0:null,Go.mode=i?3:0,up(n,t,Rx))}function Me(n,t){return n??t}function Cx(n,t,e){for(t=Me(t,0),e=Me(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function up(n,t,e){let i=e.min,s=e.max,r=Me(i.pad,0),o=Me(s.pad,0),a=Me(i.hard,-Le),l=Me(s.hard,Le),c=Me(i.soft,Le),h=Me(s.soft,-Le),d=Me(i.mode,0),u=Me(s.mode,0),f=t-n,m=as(f),v=Gi(vi(n),vi(t)),g=as(v),p=vi(g-m);(f<1e-24||p>10)&&(f=0,(n==0||t==0)&&(f=1e-24,d==2&&c!=Le&&(r=0),u==2&&h!=-Le&&(o=0)));let y=f||v||1e3,T=as(y),M=Br(10,sn(T)),R=y*(f==0?n==0?.1:1:r),A=Ne(Wp(n-R,M/10),24),_=n>=c&&(d==1||d==3&&A<=c||d==2&&A>=c)?c:Le,E=Gi(a,A<_&&n>=_?_:An(_,A)),k=y*(f==0?t==0?.1:1:o),N=Ne(ol(t+k,M/10),24),I=t<=h&&(u==1||u==3&&N>=h||u==2&&N<=h)?h:-Le,V=An(l,N>I&&t<=I?I:Gi(I,N));return E==V&&E==0&&(V=100),[E,V]}var Px=new Intl.NumberFormat(Gr?wx.language:"en-US"),Au=n=>Px.format(n),rn=Math,tl=rn.PI,vi=rn.abs,sn=rn.floor,xi=rn.round,_n=rn.ceil,An=rn.min,Gi=rn.max,Br=rn.pow,dp=rn.sign,as=rn.log10,zp=rn.log2,Ix=(n,t=1)=>rn.sinh(n)*t,lu=(n,t=1)=>rn.asinh(n/t),Le=1/0;function fp(n){return(as((n^n>>31)-(n>>31))|0)+1}function gu(n,t,e){return An(Gi(n,t),e)}function Vp(n){return typeof n=="function"}function pe(n){return Vp(n)?n:()=>n}var Lx=()=>{},Hp=n=>n,Gp=(n,t)=>t,Nx=n=>null,pp=n=>!0,mp=(n,t)=>n==t,Dx=/\.\d*?(?=9{6,}|0{6,})/gm,Qs=n=>{if($p(n)||Cs.has(n))return n;let t=`${n}`,e=t.match(Dx);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Qs(s)}e${r}`}return Ne(n,i)};function Zs(n,t){return Qs(Ne(Qs(n/t))*t)}function ol(n,t){return Qs(_n(Qs(n/t))*t)}function Wp(n,t){return Qs(sn(Qs(n/t))*t)}function Ne(n,t=0){if($p(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return xi(i)/e}var Cs=new Map;function Xp(n){return((""+n).split(".")[1]||"").length}function Xo(n,t,e,i){let s=[],r=i.map(Xp);for(let o=t;o<e;o++){let a=vi(o),l=Ne(Br(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=n==10?h:Ne(h,d);s.push(u),Cs.set(u,d)}}return s}var Wo={},Ru=[],zr=[null,null],Rs=Array.isArray,$p=Number.isInteger,Fx=n=>n===void 0;function gp(n){return typeof n=="string"}function al(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function Ux(n){return n!=null&&typeof n=="object"}var Ox=Object.getPrototypeOf(Uint8Array),qp="__proto__";function Vr(n,t=al){let e;if(Rs(n)){let i=n.find(s=>s!=null);if(Rs(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Vr(n[s],t)}else e=n.slice()}else if(n instanceof Ox)e=n.slice();else if(t(n)){e={};for(let i in n)i!=qp&&(e[i]=Vr(n[i],t))}else e=n;return e}function di(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=qp&&(al(n[s])?di(n[s],Vr(i[s])):n[s]=Vr(i[s]))}return n}var kx=0,Bx=1,zx=2;function Vx(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function Hx(n,t){if(Xx(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return $x(o[0])||(o=Wx(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],d=Array(s).fill(void 0),u=t?t[o][c]:Bx,f=[];for(let m=0;m<h.length;m++){let v=h[m],g=r.get(l[m]);v===null?u!=kx&&(d[g]=v,u==zx&&f.push(g)):d[g]=v}Vx(d,f,s),i.push(d)}}return i}var Gx=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Wx(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function Xx(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function $x(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Gi(1,sn((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Yp=["January","February","March","April","May","June","July","August","September","October","November","December"],Zp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Kp(n){return n.slice(0,3)}var qx=Zp.map(Kp),Yx=Yp.map(Kp),Zx={MMMM:Yp,MMM:Yx,WWWW:Zp,WWW:qx};function Bo(n){return(n<10?"0":"")+n}function Kx(n){return(n<10?"00":n<100?"0":"")+n}var Jx={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Bo(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Bo(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Bo(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Bo(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Bo(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Kx(n.getMilliseconds())};function Cu(n,t){t=t||Zx;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?Jx[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var jx=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Qx(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==jx?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Jp=n=>n%1==0,nl=[1,2,2.5,5],tv=Xo(10,-32,0,nl),jp=Xo(10,0,32,nl),ev=jp.filter(Jp),Ks=tv.concat(jp),Pu=`
`,Qp="{YYYY}",_p=Pu+Qp,tm="{M}/{D}",Ho=Pu+tm,ja=Ho+"/{YY}",em="{aa}",iv="{h}:{mm}",Or=iv+em,xp=Pu+Or,vp=":{ss}",we=null;function im(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Xo(10,0,3,nl).filter(Jp):Xo(10,-3,0,nl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Qp,we,we,we,we,we,we,1],[s*28,"{MMM}",_p,we,we,we,we,we,1],[s,tm,_p,we,we,we,we,we,1],[i,"{h}"+em,ja,we,Ho,we,we,we,1],[e,Or,ja,we,Ho,we,we,we,1],[t,vp,ja+" "+Or,we,Ho+" "+Or,we,xp,we,1],[n,vp+".{fff}",ja+" "+Or,we,Ho+" "+Or,we,xp,we,1]];function h(d){return(u,f,m,v,g,p)=>{let y=[],T=g>=o,M=g>=r&&g<o,R=d(m),A=Ne(R*n,3),_=cu(R.getFullYear(),T?0:R.getMonth(),M||T?1:R.getDate()),E=Ne(_*n,3);if(M||T){let k=M?g/r:0,N=T?g/o:0,I=A==E?A:Ne(cu(_.getFullYear()+N,_.getMonth()+k,1)*n,3),V=new Date(xi(I/n)),G=V.getFullYear(),D=V.getMonth();for(let H=0;I<=v;H++){let Z=cu(G+N*H,D+k*H,1),z=Z-d(Ne(Z*n,3));I=Ne((+Z+z)*n,3),I<=v&&y.push(I)}}else{let k=g>=s?s:g,N=sn(m)-sn(A),I=E+N+ol(A-E,k);y.push(I);let V=d(I),G=V.getHours()+V.getMinutes()/e+V.getSeconds()/i,D=g/i,H=u.axes[f]._space,Z=p/H;for(;I=Ne(I+g,n==1?0:3),!(I>v);)if(D>1){let z=sn(Ne(G+D,6))%24,Q=d(I).getHours()-z;Q>1&&(Q=-1),I-=Q*i,G=(G+D)%24;let st=y[y.length-1];Ne((I-st)/g,3)*Z>=.7&&y.push(I)}else y.push(I)}return y}}return[l,c,h]}var[nv,sv,rv]=im(1),[ov,av,lv]=im(.001);Xo(2,-53,53,[1]);function yp(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Mp(n,t){return(e,i,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,h,d,u,f;return i.map(m=>{let v=n(m),g=v.getFullYear(),p=v.getMonth(),y=v.getDate(),T=v.getHours(),M=v.getMinutes(),R=v.getSeconds(),A=g!=l&&a[2]||p!=c&&a[3]||y!=h&&a[4]||T!=d&&a[5]||M!=u&&a[6]||R!=f&&a[7]||a[1];return l=g,c=p,h=y,d=T,u=M,f=R,A(v)})}}function cv(n,t){let e=Cu(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function cu(n,t,e){return new Date(n,t,e)}function Sp(n,t){return t(n)}var hv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function bp(n,t){return(e,i,s,r)=>r==null?bu:t(n(i))}function uv(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function dv(n,t){return n.series[t].fill(n,t)}var fv={show:!0,live:!0,isolate:!1,mount:Lx,markers:{show:!0,width:2,stroke:uv,fill:dv,dash:"solid"},idx:null,idxs:null,values:[]};function pv(n,t){let e=n.cursor.points,i=gn(),s=e.size(n,t);He(i,zo,s),He(i,Vo,s);let r=s/-2;He(i,"marginLeft",r),He(i,"marginTop",r);let o=e.width(n,t,s);return o&&He(i,"borderWidth",o),i}function mv(n,t){let e=n.series[t].points;return e._fill||e._stroke}function gv(n,t){let e=n.series[t].points;return e._stroke||e._fill}function _v(n,t){return n.series[t].points.size}var hu=[0,0];function xv(n,t,e){return hu[0]=t,hu[1]=e,hu}function Qa(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function uu(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var vv={show:!0,x:!0,y:!0,lock:!1,move:xv,points:{one:!1,show:pv,size:_v,width:0,stroke:gv,fill:mv},bind:{mousedown:Qa,mouseup:Qa,click:Qa,dblclick:Qa,mousemove:uu,mouseleave:uu,mouseenter:uu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},nm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Iu=di({},nm,{filter:Gp}),sm=di({},Iu,{size:10}),rm=di({},nm,{show:!1}),Lu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',om="bold "+Lu,am=1.5,wp={show:!0,scale:"x",stroke:Su,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:om,side:2,grid:Iu,ticks:sm,border:rm,font:Lu,lineGap:am,rotate:0},yv="Value",Mv="Time",Ep={show:!0,scale:"x",auto:!1,sorted:1,min:Le,max:-Le,idxs:[]};function Sv(n,t,e,i,s){return t.map(r=>r==null?"":Au(r))}function bv(n,t,e,i,s,r,o){let a=[],l=Cs.get(s)||0;e=o?e:Ne(ol(e,s),l);for(let c=e;c<=i;c=Ne(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function _u(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?as:zp,h=sn(c(e));s=Br(l,h),l==10&&(s=Ks[Tn(s,Ks)]);let d=e,u=s*l;l==10&&(u=Ks[Tn(u,Ks)]);do a.push(d),d=d+s,l==10&&!Cs.has(d)&&(d=Ne(d,Cs.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=Ks[Tn(u,Ks)]));while(d<=i);return a}function wv(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?_u(n,t,Gi(l,e),i,s):[l],h=i>=0&&e<=0?[0]:[];return(e<-l?_u(n,t,Gi(l,-i),-e,s):[l]).reverse().map(u=>-u).concat(h,c)}var lm=/./,Ev=/[12357]/,Tv=/[125]/,Tp=/1/,xu=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Av(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),d=l(9,o)-h>=c?lm:l(7,o)-h>=c?Ev:l(5,o)-h>=c?Tv:Tp;if(d==Tp){let u=vi(l(1,o)-h);if(u<c)return xu(t.slice().reverse(),a.distr,d,_n(c/u)).reverse()}return xu(t,a.distr,d,1)}function Rv(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=vi(l(1,o)-l(2,o));return c<a?xu(t.slice().reverse(),3,lm,_n(a/c)).reverse():t}function Cv(n,t,e,i){return i==null?bu:t==null?"":Au(t)}var Ap={show:!0,scale:"y",stroke:Su,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:om,side:3,grid:Iu,ticks:sm,border:rm,font:Lu,lineGap:am,rotate:0};function Pv(n,t){let e=3+(n||1)*2;return Ne(e*t,3)}function Iv(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=vi(o-r),l=n.series[t],c=a/(l.points.space*be);return i[1]-i[0]<=c}var Rp={scale:null,auto:!0,sorted:0,min:Le,max:-Le},cm=(n,t,e,i,s)=>s,Cp={show:!0,auto:!0,sorted:0,gaps:cm,alpha:1,facets:[di({},Rp,{scale:"x"}),di({},Rp,{scale:"y"})]},Pp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:cm,alpha:1,points:{show:Iv,filter:null},values:null,min:Le,max:-Le,idxs:[],path:null,clip:null};function Lv(n,t,e,i,s){return e/10}var hm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Nv=di({},hm,{time:!1,ori:1}),Ip={};function um(n,t){let e=Ip[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(Ip[n]=e)),e}var Hr=1,vu=2;function tr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],u=a.left,f=a.top,m=a.width,v=a.height,g=n.valToPosH,p=n.valToPosV;return h.ori==0?e(s,l,c,h,d,g,p,u,f,m,v,cl,Wr,ul,fm,mm):e(s,l,c,h,d,p,g,f,u,v,m,hl,Xr,Fu,pm,gm)}function Nu(n,t){let e=0,i=0,s=Me(n.bands,Ru);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function Dv(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ls(n,t,e,i,s,r){return tr(n,t,(o,a,l,c,h,d,u,f,m,v,g)=>{let p=o.pxRound,y=c.dir*(c.ori==0?1:-1),T=c.ori==0?Wr:Xr,M,R;y==1?(M=e,R=i):(M=i,R=e);let A=p(d(a[M],c,v,f)),_=p(u(l[M],h,g,m)),E=p(d(a[R],c,v,f)),k=p(u(r==1?h.max:h.min,h,g,m)),N=new Path2D(s);return T(N,E,k),T(N,A,k),T(N,A,_),N})}function ll(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?ul:Fu,l=e;for(let d=0;d<n.length;d++){let u=n[d];if(u[1]>u[0]){let f=u[0]-l;f>0&&a(o,l,i,f,i+r),l=u[1]}}let c=e+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function Fv(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Du(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let d=c,u=c;if(s==1)for(;++c<=i&&t[c]===null;)u=c;else for(;--c>=e&&t[c]===null;)u=c;let f=r(n[d]),m=u==d?f:r(n[u]),v=d-s;f=o<=0&&v>=0&&v<l?r(n[v]):f;let p=u+s;m=o>=0&&p>=0&&p<l?r(n[p]):m,m>=f&&a.push([f,m])}return a}function Lp(n){return n==0?Hp:n==1?xi:t=>Zs(t,n)}function dm(n){let t=n==0?cl:hl,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=An(c,a/2,l/2),h=An(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var cl=(n,t,e)=>{n.moveTo(t,e)},hl=(n,t,e)=>{n.moveTo(e,t)},Wr=(n,t,e)=>{n.lineTo(t,e)},Xr=(n,t,e)=>{n.lineTo(e,t)},ul=dm(0),Fu=dm(1),fm=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},pm=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},mm=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},gm=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function _m(n){return(t,e,i,s,r)=>tr(t,e,(o,a,l,c,h,d,u,f,m,v,g)=>{let{pxRound:p,points:y}=o,T,M;c.ori==0?(T=cl,M=fm):(T=hl,M=pm);let R=Ne(y.width*be,3),A=(y.size-y.width)/2*be,_=Ne(A*2,3),E=new Path2D,k=new Path2D,{left:N,top:I,width:V,height:G}=t.bbox;ul(k,N-_,I-_,V+_*2,G+_*2);let D=H=>{if(l[H]!=null){let Z=p(d(a[H],c,v,f)),z=p(u(l[H],h,g,m));T(E,Z+A,z),M(E,Z,z,A,0,tl*2)}};if(r)r.forEach(D);else for(let H=i;H<=s;H++)D(H);return{stroke:R>0?E:null,fill:E,clip:k,flags:Hr|vu}})}function xm(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var Uv=xm(Wr),Ov=xm(Xr);function vm(n){let t=Me(n?.alignGaps,0);return(e,i,s,r)=>tr(e,i,(o,a,l,c,h,d,u,f,m,v,g)=>{[s,r]=sl(l,s,r);let p=o.pxRound,y=G=>p(d(G,c,v,f)),T=G=>p(u(G,h,g,m)),M,R;c.ori==0?(M=Wr,R=Uv):(M=Xr,R=Ov);let A=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Hr},E=_.stroke,k=!1;if(r-s>=v*4){let G=ut=>e.posToVal(ut,c.key,!0),D=null,H=null,Z,z,ct,K=y(a[A==1?s:r]),Q=y(a[s]),st=y(a[r]),dt=G(A==1?Q+1:st-1);for(let ut=A==1?s:r;ut>=s&&ut<=r;ut+=A){let tt=a[ut],xt=(A==1?tt<dt:tt>dt)?K:y(tt),At=l[ut];xt==K?At!=null?(z=At,D==null?(M(E,xt,T(z)),Z=D=H=z):z<D?D=z:z>H&&(H=z)):At===null&&(k=!0):(D!=null&&R(E,K,T(D),T(H),T(Z),T(z)),At!=null?(z=At,M(E,xt,T(z)),D=H=Z=z):(D=H=null,At===null&&(k=!0)),K=xt,dt=G(K+A))}D!=null&&D!=H&&ct!=K&&R(E,K,T(D),T(H),T(Z),T(z))}else for(let G=A==1?s:r;G>=s&&G<=r;G+=A){let D=l[G];D===null?k=!0:D!=null&&M(E,y(a[G]),T(D))}let[I,V]=Nu(e,i);if(o.fill!=null||I!=0){let G=_.fill=new Path2D(E),D=o.fillTo(e,i,o.min,o.max,I),H=T(D),Z=y(a[s]),z=y(a[r]);A==-1&&([z,Z]=[Z,z]),M(G,z,H),M(G,Z,H)}if(!o.spanGaps){let G=[];k&&G.push(...Du(a,l,s,r,A,y,t)),_.gaps=G=o.gaps(e,i,s,r,G),_.clip=ll(G,c.ori,f,m,v,g)}return V!=0&&(_.band=V==2?[ls(e,i,s,r,E,-1),ls(e,i,s,r,E,1)]:ls(e,i,s,r,E,V)),_})}function kv(n){let t=Me(n.align,1),e=Me(n.ascDesc,!1),i=Me(n.alignGaps,0),s=Me(n.extend,!1);return(r,o,a,l)=>tr(r,o,(c,h,d,u,f,m,v,g,p,y,T)=>{[a,l]=sl(d,a,l);let M=c.pxRound,{left:R,width:A}=r.bbox,_=Q=>M(m(Q,u,y,g)),E=Q=>M(v(Q,f,T,p)),k=u.ori==0?Wr:Xr,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Hr},I=N.stroke,V=u.dir*(u.ori==0?1:-1),G=E(d[V==1?a:l]),D=_(h[V==1?a:l]),H=D,Z=D;s&&t==-1&&(Z=R,k(I,Z,G)),k(I,D,G);for(let Q=V==1?a:l;Q>=a&&Q<=l;Q+=V){let st=d[Q];if(st==null)continue;let dt=_(h[Q]),ut=E(st);t==1?k(I,dt,G):k(I,H,ut),k(I,dt,ut),G=ut,H=dt}let z=H;s&&t==1&&(z=R+A,k(I,z,G));let[ct,K]=Nu(r,o);if(c.fill!=null||ct!=0){let Q=N.fill=new Path2D(I),st=c.fillTo(r,o,c.min,c.max,ct),dt=E(st);k(Q,z,dt),k(Q,Z,dt)}if(!c.spanGaps){let Q=[];Q.push(...Du(h,d,a,l,V,_,i));let st=c.width*be/2,dt=e||t==1?st:-st,ut=e||t==-1?-st:st;Q.forEach(tt=>{tt[0]+=dt,tt[1]+=ut}),N.gaps=Q=c.gaps(r,o,a,l,Q),N.clip=ll(Q,u.ori,g,p,y,T)}return K!=0&&(N.band=K==2?[ls(r,o,a,l,I,-1),ls(r,o,a,l,I,1)]:ls(r,o,a,l,I,K)),N})}function Np(n,t,e,i,s,r,o=Le){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let h=vi(n[l]-n[a]);h<c&&(c=h,o=vi(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function Bv(n){n=n||Wo;let t=Me(n.size,[.6,Le,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=pe(s),o=1-t[0],a=Me(t[1],Le),l=Me(t[2],1),c=Me(n.disp,Wo),h=Me(n.each,f=>{}),{fill:d,stroke:u}=c;return(f,m,v,g)=>tr(f,m,(p,y,T,M,R,A,_,E,k,N,I)=>{let V=p.pxRound,G=e,D=i*be,H=a*be,Z=l*be,z,ct;M.ori==0?[z,ct]=r(f,m):[ct,z]=r(f,m);let K=M.dir*(M.ori==0?1:-1),Q=M.ori==0?ul:Fu,st=M.ori==0?h:(Ct,$t,ne,bt,Ie,zt,Xt)=>{h(Ct,$t,ne,Ie,bt,Xt,zt)},dt=Me(f.bands,Ru).find(Ct=>Ct.series[0]==m),ut=dt!=null?dt.dir:0,tt=p.fillTo(f,m,p.min,p.max,ut),mt=V(_(tt,R,I,k)),xt,At,St,Gt=N,ie=V(p.width*be),Vt=!1,le=null,re=null,te=null,We=null;d!=null&&(ie==0||u!=null)&&(Vt=!0,le=d.values(f,m,v,g),re=new Map,new Set(le).forEach(Ct=>{Ct!=null&&re.set(Ct,new Path2D)}),ie>0&&(te=u.values(f,m,v,g),We=new Map,new Set(te).forEach(Ct=>{Ct!=null&&We.set(Ct,new Path2D)})));let{x0:De,size:ri}=c;if(De!=null&&ri!=null){G=1,y=De.values(f,m,v,g),De.unit==2&&(y=y.map(ne=>f.posToVal(E+ne*N,M.key,!0)));let Ct=ri.values(f,m,v,g);ri.unit==2?At=Ct[0]*N:At=A(Ct[0],M,N,E)-A(0,M,N,E),Gt=Np(y,T,A,M,N,E,Gt),St=Gt-At+D}else Gt=Np(y,T,A,M,N,E,Gt),St=Gt*o+D,At=Gt-St;St<1&&(St=0),ie>=At/2&&(ie=0),St<5&&(V=Hp);let Ce=St>0,bi=Gt-St-(Ce?ie:0);At=V(gu(bi,Z,H)),xt=(G==0?At/2:G==K?0:At)-G*K*((G==0?D/2:0)+(Ce?ie/2:0));let ve={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},gi=Vt?null:new Path2D,Ke=null;if(dt!=null)Ke=f.data[dt.series[1]];else{let{y0:Ct,y1:$t}=c;Ct!=null&&$t!=null&&(T=$t.values(f,m,v,g),Ke=Ct.values(f,m,v,g))}let oi=z*At,U=ct*At;for(let Ct=K==1?v:g;Ct>=v&&Ct<=g;Ct+=K){let $t=T[Ct];if($t==null)continue;if(Ke!=null){let X=Ke[Ct]??0;if($t-X==0)continue;mt=_(X,R,I,k)}let ne=M.distr!=2||c!=null?y[Ct]:Ct,bt=A(ne,M,N,E),Ie=_(Me($t,tt),R,I,k),zt=V(bt-xt),Xt=V(Gi(Ie,mt)),C=V(An(Ie,mt)),S=Xt-C;if($t!=null){let X=$t<0?U:oi,ht=$t<0?oi:U;Vt?(ie>0&&te[Ct]!=null&&Q(We.get(te[Ct]),zt,C+sn(ie/2),At,Gi(0,S-ie),X,ht),le[Ct]!=null&&Q(re.get(le[Ct]),zt,C+sn(ie/2),At,Gi(0,S-ie),X,ht)):Q(gi,zt,C+sn(ie/2),At,Gi(0,S-ie),X,ht),st(f,m,Ct,zt-ie/2,C,At+ie,S)}}return ie>0?ve.stroke=Vt?We:gi:Vt||(ve._fill=p.width==0?p._fill:p._stroke??p._fill,ve.width=0),ve.fill=Vt?re:gi,ve})}function zv(n,t){let e=Me(t?.alignGaps,0);return(i,s,r,o)=>tr(i,s,(a,l,c,h,d,u,f,m,v,g,p)=>{[r,o]=sl(c,r,o);let y=a.pxRound,T=z=>y(u(z,h,g,m)),M=z=>y(f(z,d,p,v)),R,A,_;h.ori==0?(R=cl,_=Wr,A=mm):(R=hl,_=Xr,A=gm);let E=h.dir*(h.ori==0?1:-1),k=T(l[E==1?r:o]),N=k,I=[],V=[];for(let z=E==1?r:o;z>=r&&z<=o;z+=E)if(c[z]!=null){let K=l[z],Q=T(K);I.push(N=Q),V.push(M(c[z]))}let G={stroke:n(I,V,R,_,A,y),fill:null,clip:null,band:null,gaps:null,flags:Hr},D=G.stroke,[H,Z]=Nu(i,s);if(a.fill!=null||H!=0){let z=G.fill=new Path2D(D),ct=a.fillTo(i,s,a.min,a.max,H),K=M(ct);_(z,N,K),_(z,k,K)}if(!a.spanGaps){let z=[];z.push(...Du(l,c,r,o,E,T,e)),G.gaps=z=a.gaps(i,s,r,o,z),G.clip=ll(z,h.ori,m,v,g,p)}return Z!=0&&(G.band=Z==2?[ls(i,s,r,o,D,-1),ls(i,s,r,o,D,1)]:ls(i,s,r,o,D,Z)),G})}function Vv(n){return zv(Hv,n)}function Hv(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=t[u+1]-t[u],d[u]=n[u+1]-n[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,n[u]+d[u]/3,t[u]+l[u]*d[u]/3,n[u+1]-d[u]/3,t[u+1]-l[u+1]*d[u]/3,n[u+1],t[u+1])}return a}var yu=new Set;function Dp(){for(let n of yu)n.syncRect(!0)}Gr&&(js(Sx,kr,Dp),js(bx,kr,Dp,!0),js(el,kr,()=>{Ii.pxRatio=be}));var Gv=vm(),Wv=_m();function Fp(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Mu(r,o,t,e))}function Xv(n,t){return n.map((e,i)=>i==0?{}:di({},t,e))}function Mu(n,t,e,i){return di({},t==0?e:i,n)}function ym(n,t,e){return t==null?zr:[t,e]}var $v=ym;function qv(n,t,e){return t==null?zr:il(t,e,Tu,!0)}function Mm(n,t,e,i){return t==null?zr:rl(t,e,n.scales[i].log,!1)}var Yv=Mm;function Sm(n,t,e,i){return t==null?zr:Eu(t,e,n.scales[i].log,!1)}var Zv=Sm;function Kv(n,t,e,i,s){let r=Gi(fp(n),fp(t)),o=t-n,a=Tn(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Cs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Up(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=xi((e=+s)*be))+"px"),[n,t,e]}function Jv(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ne(t[2]*be,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Ii(n,t,e){let i={mode:Me(n.mode,1)},s=i.mode;function r(x,b,P,L){let B=b.valToPct(x);return L+P*(b.dir==-1?1-B:B)}function o(x,b,P,L){let B=b.valToPct(x);return L+P*(b.dir==-1?B:1-B)}function a(x,b,P,L){return b.ori==0?r(x,b,P,L):o(x,b,P,L)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=gn(sx);if(n.id!=null&&(c.id=n.id),nn(c,n.class),n.title){let x=gn(ax,c);x.textContent=n.title}let h=En("canvas"),d=i.ctx=h.getContext("2d"),u=gn(lx,c);js("click",u,x=>{x.target===m&&(ke!=Tr||Xe!=Ar)&&Pi.click(i,x)},!0);let f=i.under=gn(cx,u);u.appendChild(h);let m=i.over=gn(hx,u);n=Vr(n);let v=+Me(n.pxAlign,1),g=Lp(v);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let p=n.ms||.001,y=i.series=s==1?Fp(n.series||[],Ep,Pp,!1):Xv(n.series||[null],Cp),T=i.axes=Fp(n.axes||[],wp,Ap,!0),M=i.scales={},R=i.bands=n.bands||[];R.forEach(x=>{x.fill=pe(x.fill||null),x.dir=Me(x.dir,-1)});let A=s==2?y[1].facets[0].scale:y[0].scale,_={axes:ss,series:ue},E=(n.drawOrder||["axes","series"]).map(x=>_[x]);function k(x){let b=x.distr==3?P=>as(P>0?P:x.clamp(i,P,x.min,x.max,x.key)):x.distr==4?P=>lu(P,x.asinh):x.distr==100?P=>x.fwd(P):P=>P;return P=>{let L=b(P),{_min:B,_max:Y}=x,at=Y-B;return(L-B)/at}}function N(x){let b=M[x];if(b==null){let P=(n.scales||Wo)[x]||Wo;if(P.from!=null){N(P.from);let L=di({},M[P.from],P,{key:x});L.valToPct=k(L),M[x]=L}else{b=M[x]=di({},x==A?hm:Nv,P),b.key=x;let L=b.time,B=b.range,Y=Rs(B);if((x!=A||s==2&&!L)&&(Y&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?hp:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?hp:{mode:1,hard:B[1],soft:B[1]}},Y=!1),!Y&&al(B))){let at=B;B=(ft,yt,Nt)=>yt==null?zr:il(yt,Nt,at)}b.range=pe(B||(L?$v:x==A?b.distr==3?Yv:b.distr==4?Zv:ym:b.distr==3?Mm:b.distr==4?Sm:qv)),b.auto=pe(Y?!1:b.auto),b.clamp=pe(b.clamp||Lv),b._min=b._max=null,b.valToPct=k(b)}}}N("x"),N("y"),s==1&&y.forEach(x=>{N(x.scale)}),T.forEach(x=>{N(x.scale)});for(let x in n.scales)N(x);let I=M[A],V=I.distr,G,D;I.ori==0?(nn(c,rx),G=r,D=o):(nn(c,ox),G=o,D=r);let H={};for(let x in M){let b=M[x];(b.min!=null||b.max!=null)&&(H[x]={min:b.min,max:b.max},b.min=b.max=null)}let Z=n.tzDate||(x=>new Date(xi(x/p))),z=n.fmtDate||Cu,ct=p==1?rv(Z):lv(Z),K=Mp(Z,yp(p==1?sv:av,z)),Q=bp(Z,Sp(hv,z)),st=[],dt=i.legend=di({},fv,n.legend),ut=i.cursor=di({},vv,{drag:{y:s==2}},n.cursor),tt=dt.show,mt=ut.show,xt=dt.markers;dt.idxs=st,xt.width=pe(xt.width),xt.dash=pe(xt.dash),xt.stroke=pe(xt.stroke),xt.fill=pe(xt.fill);let At,St,Gt,ie=[],Vt=[],le,re=!1,te={};if(dt.live){let x=y[1]?y[1].values:null;re=x!=null,le=re?x(i,1,0):{_:0};for(let b in le)te[b]=bu}if(tt)if(At=En("table",gx,c),Gt=En("tbody",null,At),dt.mount(i,At),re){St=En("thead",null,At,Gt);let x=En("tr",null,St);En("th",null,x);for(var We in le)En("th",Jf,x).textContent=We}else nn(At,xx),dt.live&&nn(At,_x);let De={show:!0},ri={show:!1};function Ce(x,b){if(b==0&&(re||!dt.live||s==2))return zr;let P=[],L=En("tr",vx,Gt,Gt.childNodes[b]);nn(L,x.class),x.show||nn(L,Js);let B=En("th",null,L);if(xt.show){let ft=gn(yx,B);if(b>0){let yt=xt.width(i,b);yt&&(ft.style.border=yt+"px "+xt.dash(i,b)+" "+xt.stroke(i,b)),ft.style.background=xt.fill(i,b)}}let Y=gn(Jf,B);x.label instanceof HTMLElement?Y.appendChild(x.label):Y.textContent=x.label,b>0&&(xt.show||(Y.style.color=x.width>0?xt.stroke(i,b):xt.fill(i,b)),ve("click",B,ft=>{if(ut._lock)return;Zt(ft);let yt=y.indexOf(x);if((ft.ctrlKey||ft.metaKey)!=dt.isolate){let Nt=y.some((Dt,Ut)=>Ut>0&&Ut!=yt&&Dt.show);y.forEach((Dt,Ut)=>{Ut>0&&zn(Ut,Nt?Ut==yt?De:ri:De,!0,hi.setSeries)})}else zn(yt,{show:!x.show},!0,hi.setSeries)},!1),Kt&&ve(ep,B,ft=>{ut._lock||(Zt(ft),zn(y.indexOf(x),Cr,!0,hi.setSeries))},!1));for(var at in le){let ft=En("td",Mx,L);ft.textContent="--",P.push(ft)}return[L,P]}let bi=new Map;function ve(x,b,P,L=!0){let B=bi.get(b)||{},Y=ut.bind[x](i,b,P,L);Y&&(js(x,b,B[x]=Y),bi.set(b,B))}function gi(x,b,P){let L=bi.get(b)||{};for(let B in L)(x==null||B==x)&&(mu(B,b,L[B]),delete L[B]);x==null&&bi.delete(b)}let Ke=0,oi=0,U=0,Ct=0,$t=0,ne=0,bt=$t,Ie=ne,zt=U,Xt=Ct,C=0,S=0,X=0,ht=0;i.bbox={};let ot=!1,_t=!1,vt=!1,et=!1,nt=!1,pt=!1;function F(x,b,P){(P||x!=i.width||b!=i.height)&&rt(x,b),oe(!1),vt=!0,_t=!0,Li()}function rt(x,b){i.width=Ke=U=x,i.height=oi=Ct=b,$t=ne=0,Mt(),Ht();let P=i.bbox;C=P.left=Zs($t*be,.5),S=P.top=Zs(ne*be,.5),X=P.width=Zs(U*be,.5),ht=P.height=Zs(Ct*be,.5)}let it=3;function wt(){let x=!1,b=0;for(;!x;){b++;let P=br(b),L=Bn(b);x=b==it||P&&L,x||(rt(i.width,i.height),_t=!0)}}function gt({width:x,height:b}){F(x,b)}i.setSize=gt;function Mt(){let x=!1,b=!1,P=!1,L=!1;T.forEach((B,Y)=>{if(B.show&&B._show){let{side:at,_size:ft}=B,yt=at%2,Nt=B.label!=null?B.labelSize:0,Dt=ft+Nt;Dt>0&&(yt?(U-=Dt,at==3?($t+=Dt,L=!0):P=!0):(Ct-=Dt,at==0?(ne+=Dt,x=!0):b=!0))}}),On[0]=x,On[1]=P,On[2]=b,On[3]=L,U-=Sn[1]+Sn[3],$t+=Sn[3],Ct-=Sn[2]+Sn[0],ne+=Sn[0]}function Ht(){let x=$t+U,b=ne+Ct,P=$t,L=ne;function B(Y,at){switch(Y){case 1:return x+=at,x-at;case 2:return b+=at,b-at;case 3:return P-=at,P+at;case 0:return L-=at,L+at}}T.forEach((Y,at)=>{if(Y.show&&Y._show){let ft=Y.side;Y._pos=B(ft,Y._size),Y.label!=null&&(Y._lpos=B(ft,Y.labelSize))}})}if(ut.dataIdx==null){let x=ut.hover,b=x.skip=new Set(x.skip??[]);b.add(void 0);let P=x.prox=pe(x.prox),L=x.bias??=0;ut.dataIdx=(B,Y,at,ft)=>{if(Y==0)return at;let yt=at,Nt=P(B,Y,at,ft)??Le,Dt=Nt>=0&&Nt<Le,Ut=I.ori==0?U:Ct,ee=ut.left,Se=t[0],ye=t[Y];if(b.has(ye[at])){yt=null;let de=null,qt=null,Wt;if(L==0||L==-1)for(Wt=at;de==null&&Wt-- >0;)b.has(ye[Wt])||(de=Wt);if(L==0||L==1)for(Wt=at;qt==null&&Wt++<ye.length;)b.has(ye[Wt])||(qt=Wt);if(de!=null||qt!=null)if(Dt){let ze=de==null?-1/0:G(Se[de],I,Ut,0),Qe=qt==null?1/0:G(Se[qt],I,Ut,0),Ai=ee-ze,Pe=Qe-ee;Ai<=Pe?Ai<=Nt&&(yt=de):Pe<=Nt&&(yt=qt)}else yt=qt==null?de:de==null?qt:at-de<=qt-at?de:qt}else Dt&&vi(ee-G(Se[at],I,Ut,0))>Nt&&(yt=null);return yt}}let Zt=x=>{ut.event=x};ut.idxs=st,ut._lock=!1;let lt=ut.points;lt.show=pe(lt.show),lt.size=pe(lt.size),lt.stroke=pe(lt.stroke),lt.width=pe(lt.width),lt.fill=pe(lt.fill);let Ot=i.focus=di({},n.focus||{alpha:.3},ut.focus),Kt=Ot.prox>=0,Rt=Kt&&lt.one,se=[],Oe=[],ki=[];function To(x,b){let P=lt.show(i,b);if(P instanceof HTMLElement)return nn(P,mx),nn(P,x.class),Wn(P,-10,-10,U,Ct),m.insertBefore(P,se[b]),P}function yr(x,b){if(s==1||b>0){let P=s==1&&M[x.scale].time,L=x.value;x.value=P?gp(L)?bp(Z,Sp(L,z)):L||Q:L||Cv,x.label=x.label||(P?Mv:yv)}if(Rt||b>0){x.width=x.width==null?1:x.width,x.paths=x.paths||Gv||Nx,x.fillTo=pe(x.fillTo||Dv),x.pxAlign=+Me(x.pxAlign,v),x.pxRound=Lp(x.pxAlign),x.stroke=pe(x.stroke||null),x.fill=pe(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let P=Pv(Gi(1,x.width),1),L=x.points=di({},{size:P,width:Gi(1,P*.2),stroke:x.stroke,space:P*2,paths:Wv,_stroke:null,_fill:null},x.points);L.show=pe(L.show),L.filter=pe(L.filter),L.fill=pe(L.fill),L.stroke=pe(L.stroke),L.paths=pe(L.paths),L.pxAlign=x.pxAlign}if(tt){let P=Ce(x,b);ie.splice(b,0,P[0]),Vt.splice(b,0,P[1]),dt.values.push(null)}if(mt){st.splice(b,0,null);let P=null;Rt?b==0&&(P=To(x,b)):b>0&&(P=To(x,b)),se.splice(b,0,P),Oe.splice(b,0,0),ki.splice(b,0,0)}Ti("addSeries",b)}function qh(x,b){b=b??y.length,x=s==1?Mu(x,b,Ep,Pp):Mu(x,b,{},Cp),y.splice(b,0,x),yr(y[b],b)}i.addSeries=qh;function ka(x){if(y.splice(x,1),tt){dt.values.splice(x,1),Vt.splice(x,1);let b=ie.splice(x,1)[0];gi(null,b.firstChild),b.remove()}mt&&(st.splice(x,1),se.splice(x,1)[0].remove(),Oe.splice(x,1),ki.splice(x,1)),Ti("delSeries",x)}i.delSeries=ka;let On=[!1,!1,!1,!1];function es(x,b){if(x._show=x.show,x.show){let P=x.side%2,L=M[x.scale];L==null&&(x.scale=P?y[1].scale:A,L=M[x.scale]);let B=L.time;x.size=pe(x.size),x.space=pe(x.space),x.rotate=pe(x.rotate),Rs(x.incrs)&&x.incrs.forEach(at=>{!Cs.has(at)&&Cs.set(at,Xp(at))}),x.incrs=pe(x.incrs||(L.distr==2?ev:B?p==1?nv:ov:Ks)),x.splits=pe(x.splits||(B&&L.distr==1?ct:L.distr==3?_u:L.distr==4?wv:bv)),x.stroke=pe(x.stroke),x.grid.stroke=pe(x.grid.stroke),x.ticks.stroke=pe(x.ticks.stroke),x.border.stroke=pe(x.border.stroke);let Y=x.values;x.values=Rs(Y)&&!Rs(Y[0])?pe(Y):B?Rs(Y)?Mp(Z,yp(Y,z)):gp(Y)?cv(Z,Y):Y||K:Y||Sv,x.filter=pe(x.filter||(L.distr>=3&&L.log==10?Av:L.distr==3&&L.log==2?Rv:Gp)),x.font=Up(x.font),x.labelFont=Up(x.labelFont),x._size=x.size(i,null,b,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(On[b]=!0,x._el=gn(ux,u))}}function is(x,b,P,L){let[B,Y,at,ft]=P,yt=b%2,Nt=0;return yt==0&&(ft||Y)&&(Nt=b==0&&!B||b==2&&!at?xi(wp.size/3):0),yt==1&&(B||at)&&(Nt=b==1&&!Y||b==3&&!ft?xi(Ap.size/2):0),Nt}let Ao=i.padding=(n.padding||[is,is,is,is]).map(x=>pe(Me(x,is))),Sn=i._padding=Ao.map((x,b)=>x(i,b,On,0)),Je,ii=null,ni=null,kn=s==1?y[0].idxs:null,ji=null,Ss=!1;function Ro(x,b){if(t=x??[],i.data=i._data=t,s==2){Je=0;for(let P=1;P<y.length;P++)Je+=t[P][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ji=t[0],Je=ji.length;let P=t;if(V==2){P=t.slice();let L=P[0]=Array(Je);for(let B=0;B<Je;B++)L[B]=B}i._data=t=P}if(oe(!0),Ti("setData"),V==2&&(vt=!0),b!==!1){let P=I;P.auto(i,Ss)?Co():Es(A,P.min,P.max),et=et||ut.left>=0,pt=!0,Li()}}i.setData=Ro;function Co(){Ss=!0;let x,b;s==1&&(Je>0?(ii=kn[0]=0,ni=kn[1]=Je-1,x=t[0][ii],b=t[0][ni],V==2?(x=ii,b=ni):x==b&&(V==3?[x,b]=rl(x,x,I.log,!1):V==4?[x,b]=Eu(x,x,I.log,!1):I.time?b=x+xi(86400/p):[x,b]=il(x,b,Tu,!0))):(ii=kn[0]=x=null,ni=kn[1]=b=null)),Es(A,x,b)}let Mr,bs,Sr,w,O,j,$,q,Et,Pt;function Tt(x,b,P,L,B,Y){x??=Qf,P??=Ru,L??="butt",B??=Qf,Y??="round",x!=Mr&&(d.strokeStyle=Mr=x),B!=bs&&(d.fillStyle=bs=B),b!=Sr&&(d.lineWidth=Sr=b),Y!=O&&(d.lineJoin=O=Y),L!=j&&(d.lineCap=j=L),P!=w&&d.setLineDash(w=P)}function It(x,b,P,L){b!=bs&&(d.fillStyle=bs=b),x!=$&&(d.font=$=x),P!=q&&(d.textAlign=q=P),L!=Et&&(d.textBaseline=Et=L)}function Bt(x,b,P,L,B=0){if(L.length>0&&x.auto(i,Ss)&&(b==null||b.min==null)){let Y=Me(ii,0),at=Me(ni,L.length-1),ft=P.min==null?Ax(L,Y,at,B,x.distr==3):[P.min,P.max];x.min=An(x.min,P.min=ft[0]),x.max=Gi(x.max,P.max=ft[1])}}let Jt={min:null,max:null};function he(){for(let L in M){let B=M[L];H[L]==null&&(B.min==null||H[A]!=null&&B.auto(i,Ss))&&(H[L]=Jt)}for(let L in M){let B=M[L];H[L]==null&&B.from!=null&&H[B.from]!=null&&(H[L]=Jt)}H[A]!=null&&oe(!0);let x={};for(let L in H){let B=H[L];if(B!=null){let Y=x[L]=Vr(M[L],Ux);if(B.min!=null)di(Y,B);else if(L!=A||s==2)if(Je==0&&Y.from==null){let at=Y.range(i,null,null,L);Y.min=at[0],Y.max=at[1]}else Y.min=Le,Y.max=-Le}}if(Je>0){y.forEach((L,B)=>{if(s==1){let Y=L.scale,at=H[Y];if(at==null)return;let ft=x[Y];if(B==0){let yt=ft.range(i,ft.min,ft.max,Y);ft.min=yt[0],ft.max=yt[1],ii=Tn(ft.min,t[0]),ni=Tn(ft.max,t[0]),ni-ii>1&&(t[0][ii]<ft.min&&ii++,t[0][ni]>ft.max&&ni--),L.min=ji[ii],L.max=ji[ni]}else L.show&&L.auto&&Bt(ft,at,L,t[B],L.sorted);L.idxs[0]=ii,L.idxs[1]=ni}else if(B>0&&L.show&&L.auto){let[Y,at]=L.facets,ft=Y.scale,yt=at.scale,[Nt,Dt]=t[B],Ut=x[ft],ee=x[yt];Ut!=null&&Bt(Ut,H[ft],Y,Nt,Y.sorted),ee!=null&&Bt(ee,H[yt],at,Dt,at.sorted),L.min=at.min,L.max=at.max}});for(let L in x){let B=x[L],Y=H[L];if(B.from==null&&(Y==null||Y.min==null)){let at=B.range(i,B.min==Le?null:B.min,B.max==-Le?null:B.max,L);B.min=at[0],B.max=at[1]}}}for(let L in x){let B=x[L];if(B.from!=null){let Y=x[B.from];if(Y.min==null)B.min=B.max=null;else{let at=B.range(i,Y.min,Y.max,L);B.min=at[0],B.max=at[1]}}}let b={},P=!1;for(let L in x){let B=x[L],Y=M[L];if(Y.min!=B.min||Y.max!=B.max){Y.min=B.min,Y.max=B.max;let at=Y.distr;Y._min=at==3?as(Y.min):at==4?lu(Y.min,Y.asinh):at==100?Y.fwd(Y.min):Y.min,Y._max=at==3?as(Y.max):at==4?lu(Y.max,Y.asinh):at==100?Y.fwd(Y.max):Y.max,b[L]=P=!0}}if(P){y.forEach((L,B)=>{s==2?B>0&&b.y&&(L._paths=null):b[L.scale]&&(L._paths=null)});for(let L in b)vt=!0,Ti("setScale",L);mt&&ut.left>=0&&(et=pt=!0)}for(let L in H)H[L]=null}function kt(x){let b=gu(ii-1,0,Je-1),P=gu(ni+1,0,Je-1);for(;x[b]==null&&b>0;)b--;for(;x[P]==null&&P<Je-1;)P++;return[b,P]}function ue(){if(Je>0){let x=y.some(b=>b._focus)&&Pt!=Ot.alpha;x&&(d.globalAlpha=Pt=Ot.alpha),y.forEach((b,P)=>{if(P>0&&b.show&&(qe(P,!1),qe(P,!0),b._paths==null)){let L=Pt;Pt!=b.alpha&&(d.globalAlpha=Pt=b.alpha);let B=s==2?[0,t[P][0].length-1]:kt(t[P]);b._paths=b.paths(i,P,B[0],B[1]),Pt!=L&&(d.globalAlpha=Pt=L)}}),y.forEach((b,P)=>{if(P>0&&b.show){let L=Pt;Pt!=b.alpha&&(d.globalAlpha=Pt=b.alpha),b._paths!=null&&Te(P,!1);{let B=b._paths!=null?b._paths.gaps:null,Y=b.points.show(i,P,ii,ni,B),at=b.points.filter(i,P,Y,B);(Y||at)&&(b.points._paths=b.points.paths(i,P,ii,ni,at),Te(P,!0))}Pt!=L&&(d.globalAlpha=Pt=L),Ti("drawSeries",P)}}),x&&(d.globalAlpha=Pt=1)}}function qe(x,b){let P=b?y[x].points:y[x];P._stroke=P.stroke(i,x),P._fill=P.fill(i,x)}function Te(x,b){let P=b?y[x].points:y[x],{stroke:L,fill:B,clip:Y,flags:at,_stroke:ft=P._stroke,_fill:yt=P._fill,_width:Nt=P.width}=P._paths;Nt=Ne(Nt*be,3);let Dt=null,Ut=Nt%2/2;b&&yt==null&&(yt=Nt>0?"#fff":ft);let ee=P.pxAlign==1&&Ut>0;if(ee&&d.translate(Ut,Ut),!b){let Se=C-Nt/2,ye=S-Nt/2,de=X+Nt,qt=ht+Nt;Dt=new Path2D,Dt.rect(Se,ye,de,qt)}b?Ft(ft,Nt,P.dash,P.cap,yt,L,B,at,Y):Ae(x,ft,Nt,P.dash,P.cap,yt,L,B,at,Dt,Y),ee&&d.translate(-Ut,-Ut)}function Ae(x,b,P,L,B,Y,at,ft,yt,Nt,Dt){let Ut=!1;yt!=0&&R.forEach((ee,Se)=>{if(ee.series[0]==x){let ye=y[ee.series[1]],de=t[ee.series[1]],qt=(ye._paths||Wo).band;Rs(qt)&&(qt=ee.dir==1?qt[0]:qt[1]);let Wt,ze=null;ye.show&&qt&&Cx(de,ii,ni)?(ze=ee.fill(i,Se)||Y,Wt=ye._paths.clip):qt=null,Ft(b,P,L,B,ze,at,ft,yt,Nt,Dt,Wt,qt),Ut=!0}}),Ut||Ft(b,P,L,B,Y,at,ft,yt,Nt,Dt)}let _i=Hr|vu;function Ft(x,b,P,L,B,Y,at,ft,yt,Nt,Dt,Ut){Tt(x,b,P,L,B),(yt||Nt||Ut)&&(d.save(),yt&&d.clip(yt),Nt&&d.clip(Nt)),Ut?(ft&_i)==_i?(d.clip(Ut),Dt&&d.clip(Dt),fe(B,at),ai(x,Y,b)):ft&vu?(fe(B,at),d.clip(Ut),ai(x,Y,b)):ft&Hr&&(d.save(),d.clip(Ut),Dt&&d.clip(Dt),fe(B,at),d.restore(),ai(x,Y,b)):(fe(B,at),ai(x,Y,b)),(yt||Nt||Ut)&&d.restore()}function ai(x,b,P){P>0&&(b instanceof Map?b.forEach((L,B)=>{d.strokeStyle=Mr=B,d.stroke(L)}):b!=null&&x&&d.stroke(b))}function fe(x,b){b instanceof Map?b.forEach((P,L)=>{d.fillStyle=bs=L,d.fill(P)}):b!=null&&x&&d.fill(b)}function ns(x,b,P,L){let B=T[x],Y;if(L<=0)Y=[0,0];else{let at=B._space=B.space(i,x,b,P,L),ft=B._incrs=B.incrs(i,x,b,P,L,at);Y=Kv(b,P,ft,L,at)}return B._found=Y}function li(x,b,P,L,B,Y,at,ft,yt,Nt){let Dt=at%2/2;v==1&&d.translate(Dt,Dt),Tt(ft,at,yt,Nt,ft),d.beginPath();let Ut,ee,Se,ye,de=B+(L==0||L==3?-Y:Y);P==0?(ee=B,ye=de):(Ut=B,Se=de);for(let qt=0;qt<x.length;qt++)b[qt]!=null&&(P==0?Ut=Se=x[qt]:ee=ye=x[qt],d.moveTo(Ut,ee),d.lineTo(Se,ye));d.stroke(),v==1&&d.translate(-Dt,-Dt)}function br(x){let b=!0;return T.forEach((P,L)=>{if(!P.show)return;let B=M[P.scale];if(B.min==null){P._show&&(b=!1,P._show=!1,oe(!1));return}else P._show||(b=!1,P._show=!0,oe(!1));let Y=P.side,at=Y%2,{min:ft,max:yt}=B,[Nt,Dt]=ns(L,ft,yt,at==0?U:Ct);if(Dt==0)return;let Ut=B.distr==2,ee=P._splits=P.splits(i,L,ft,yt,Nt,Dt,Ut),Se=B.distr==2?ee.map(Wt=>ji[Wt]):ee,ye=B.distr==2?ji[ee[1]]-ji[ee[0]]:Nt,de=P._values=P.values(i,P.filter(i,Se,L,Dt,ye),L,Dt,ye);P._rotate=Y==2?P.rotate(i,de,L,Dt):0;let qt=P._size;P._size=_n(P.size(i,de,L,x)),qt!=null&&P._size!=qt&&(b=!1)}),b}function Bn(x){let b=!0;return Ao.forEach((P,L)=>{let B=P(i,L,On,x);B!=Sn[L]&&(b=!1),Sn[L]=B}),b}function ss(){for(let x=0;x<T.length;x++){let b=T[x];if(!b.show||!b._show)continue;let P=b.side,L=P%2,B,Y,at=b.stroke(i,x),ft=P==0||P==3?-1:1,[yt,Nt]=b._found;if(b.label!=null){let Vi=b.labelGap*ft,en=xi((b._lpos+Vi)*be);It(b.labelFont[0],at,"center",P==2?"top":jf),d.save(),L==1?(B=Y=0,d.translate(en,xi(S+ht/2)),d.rotate((P==3?-tl:tl)/2)):(B=xi(C+X/2),Y=en);let qs=Vp(b.label)?b.label(i,x,yt,Nt):b.label;d.fillText(qs,B,Y),d.restore()}if(Nt==0)continue;let Dt=M[b.scale],Ut=L==0?X:ht,ee=L==0?C:S,Se=b._splits,ye=Dt.distr==2?Se.map(Vi=>ji[Vi]):Se,de=Dt.distr==2?ji[Se[1]]-ji[Se[0]]:yt,qt=b.ticks,Wt=b.border,ze=qt.show?qt.size:0,Qe=xi(ze*be),Ai=xi((b.alignTo==2?b._size-ze-b.gap:b.gap)*be),Pe=b._rotate*-tl/180,ti=g(b._pos*be),Qi=(Qe+Ai)*ft,zi=ti+Qi;Y=L==0?zi:0,B=L==1?zi:0;let fn=b.font[0],bn=b.align==1?Ur:b.align==2?ru:Pe>0?Ur:Pe<0?ru:L==0?"center":P==3?ru:Ur,Hn=Pe||L==1?"middle":P==2?"top":jf;It(fn,at,bn,Hn);let tn=b.font[1]*b.lineGap,pn=Se.map(Vi=>g(a(Vi,Dt,Ut,ee))),wn=b._values;for(let Vi=0;Vi<wn.length;Vi++){let en=wn[Vi];if(en!=null){L==0?B=pn[Vi]:Y=pn[Vi],en=""+en;let qs=en.indexOf(`
`)==-1?[en]:en.split(/\n/gm);for(let Hi=0;Hi<qs.length;Hi++){let Vf=qs[Hi];Pe?(d.save(),d.translate(B,Y+Hi*tn),d.rotate(Pe),d.fillText(Vf,0,0),d.restore()):d.fillText(Vf,B,Y+Hi*tn)}}}qt.show&&li(pn,qt.filter(i,ye,x,Nt,de),L,P,ti,Qe,Ne(qt.width*be,3),qt.stroke(i,x),qt.dash,qt.cap);let Gn=b.grid;Gn.show&&li(pn,Gn.filter(i,ye,x,Nt,de),L,L==0?2:1,L==0?S:C,L==0?ht:X,Ne(Gn.width*be,3),Gn.stroke(i,x),Gn.dash,Gn.cap),Wt.show&&li([ti],[1],L==0?1:0,L==0?1:2,L==1?S:C,L==1?ht:X,Ne(Wt.width*be,3),Wt.stroke(i,x),Wt.dash,Wt.cap)}Ti("drawAxes")}function oe(x){y.forEach((b,P)=>{P>0&&(b._paths=null,x&&(s==1?(b.min=null,b.max=null):b.facets.forEach(L=>{L.min=null,L.max=null})))})}let je=!1,Bi=!1,Re=[];function ci(){Bi=!1;for(let x=0;x<Re.length;x++)Ti(...Re[x]);Re.length=0}function Li(){je||(Gx(bf),je=!0)}function Ba(x,b=!1){je=!0,Bi=b,x(i),bf(),b&&Re.length>0&&queueMicrotask(ci)}i.batch=Ba;function bf(){if(ot&&(he(),ot=!1),vt&&(wt(),vt=!1),_t){if(He(f,Ur,$t),He(f,"top",ne),He(f,zo,U),He(f,Vo,Ct),He(m,Ur,$t),He(m,"top",ne),He(m,zo,U),He(m,Vo,Ct),He(u,zo,Ke),He(u,Vo,oi),h.width=xi(Ke*be),h.height=xi(oi*be),T.forEach(({_el:x,_show:b,_size:P,_pos:L,side:B})=>{if(x!=null)if(b){let Y=B===3||B===0?P:0,at=B%2==1;He(x,at?"left":"top",L-Y),He(x,at?"width":"height",P),He(x,at?"top":"left",at?ne:$t),He(x,at?"height":"width",at?Ct:U),pu(x,Js)}else nn(x,Js)}),Mr=bs=Sr=O=j=$=q=Et=w=null,Pt=1,Lo(!0),$t!=bt||ne!=Ie||U!=zt||Ct!=Xt){oe(!1);let x=U/zt,b=Ct/Xt;if(mt&&!et&&ut.left>=0){ut.left*=x,ut.top*=b,wr&&Wn(wr,xi(ut.left),0,U,Ct),Er&&Wn(Er,0,xi(ut.top),U,Ct);for(let P=0;P<se.length;P++){let L=se[P];L!=null&&(Oe[P]*=x,ki[P]*=b,Wn(L,_n(Oe[P]),_n(ki[P]),U,Ct))}}if(Be.show&&!nt&&Be.left>=0&&Be.width>0){Be.left*=x,Be.width*=x,Be.top*=b,Be.height*=b;for(let P in Qh)He(Rr,P,Be[P])}bt=$t,Ie=ne,zt=U,Xt=Ct}Ti("setSize"),_t=!1}Ke>0&&oi>0&&(d.clearRect(0,0,h.width,h.height),Ti("drawClear"),E.forEach(x=>x()),Ti("draw")),Be.show&&nt&&(za(Be),nt=!1),mt&&et&&($s(null,!0,!1),et=!1),dt.show&&dt.live&&pt&&(Jh(),pt=!1),l||(l=!0,i.status=1,Ti("ready")),Ss=!1,je=!1}i.redraw=(x,b)=>{vt=b||!1,x!==!1?Es(A,I.min,I.max):Li()};function Yh(x,b){let P=M[x];if(P.from==null){if(Je==0){let L=P.range(i,b.min,b.max,x);b.min=L[0],b.max=L[1]}if(b.min>b.max){let L=b.min;b.min=b.max,b.max=L}if(Je>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;x==A&&P.distr==2&&Je>0&&(b.min=Tn(b.min,t[0]),b.max=Tn(b.max,t[0]),b.min==b.max&&b.max++),H[x]=b,ot=!0,Li()}}i.setScale=Yh;let Zh,Kh,wr,Er,wf,Ef,Tr,Ar,Tf,Af,ke,Xe,ws=!1,Pi=ut.drag,wi=Pi.x,Ei=Pi.y;mt&&(ut.x&&(Zh=gn(fx,m)),ut.y&&(Kh=gn(px,m)),I.ori==0?(wr=Zh,Er=Kh):(wr=Kh,Er=Zh),ke=ut.left,Xe=ut.top);let Be=i.select=di({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Rr=Be.show?gn(dx,Be.over?m:f):null;function za(x,b){if(Be.show){for(let P in x)Be[P]=x[P],P in Qh&&He(Rr,P,x[P]);b!==!1&&Ti("setSelect")}}i.setSelect=za;function v_(x){if(y[x].show)tt&&pu(ie[x],Js);else if(tt&&nn(ie[x],Js),mt){let P=Rt?se[0]:se[x];P!=null&&Wn(P,-10,-10,U,Ct)}}function Es(x,b,P){Yh(x,{min:b,max:P})}function zn(x,b,P,L){b.focus!=null&&w_(x),b.show!=null&&y.forEach((B,Y)=>{Y>0&&(x==Y||x==null)&&(B.show=b.show,v_(Y),s==2?(Es(B.facets[0].scale,null,null),Es(B.facets[1].scale,null,null)):Es(B.scale,null,null),Li())}),P!==!1&&Ti("setSeries",x,b),L&&No("setSeries",i,x,b)}i.setSeries=zn;function y_(x,b){di(R[x],b)}function M_(x,b){x.fill=pe(x.fill||null),x.dir=Me(x.dir,-1),b=b??R.length,R.splice(b,0,x)}function S_(x){x==null?R.length=0:R.splice(x,1)}i.addBand=M_,i.setBand=y_,i.delBand=S_;function b_(x,b){y[x].alpha=b,mt&&se[x]!=null&&(se[x].style.opacity=b),tt&&ie[x]&&(ie[x].style.opacity=b)}let rs,Ts,Xs,Cr={focus:!0};function w_(x){if(x!=Xs){let b=x==null,P=Ot.alpha!=1;y.forEach((L,B)=>{if(s==1||B>0){let Y=b||B==0||B==x;L._focus=b?null:Y,P&&b_(B,Y?1:Ot.alpha)}}),Xs=x,P&&Li()}}tt&&Kt&&ve(ip,At,x=>{ut._lock||(Zt(x),Xs!=null&&zn(null,Cr,!0,hi.setSeries))});function Vn(x,b,P){let L=M[b];P&&(x=x/be-(L.ori==1?ne:$t));let B=U;L.ori==1&&(B=Ct,x=B-x),L.dir==-1&&(x=B-x);let Y=L._min,at=L._max,ft=x/B,yt=Y+(at-Y)*ft,Nt=L.distr;return Nt==3?Br(10,yt):Nt==4?Ix(yt,L.asinh):Nt==100?L.bwd(yt):yt}function E_(x,b){let P=Vn(x,A,b);return Tn(P,t[0],ii,ni)}i.valToIdx=x=>Tn(x,t[0]),i.posToIdx=E_,i.posToVal=Vn,i.valToPos=(x,b,P)=>M[b].ori==0?r(x,M[b],P?X:U,P?C:0):o(x,M[b],P?ht:Ct,P?S:0),i.setCursor=(x,b,P)=>{ke=x.left,Xe=x.top,$s(null,b,P)};function Rf(x,b){He(Rr,Ur,Be.left=x),He(Rr,zo,Be.width=b)}function Cf(x,b){He(Rr,"top",Be.top=x),He(Rr,Vo,Be.height=b)}let Po=I.ori==0?Rf:Cf,Io=I.ori==1?Rf:Cf;function T_(){if(tt&&dt.live)for(let x=s==2?1:0;x<y.length;x++){if(x==0&&re)continue;let b=dt.values[x],P=0;for(let L in b)Vt[x][P++].firstChild.nodeValue=b[L]}}function Jh(x,b){if(x!=null&&(x.idxs?x.idxs.forEach((P,L)=>{st[L]=P}):Fx(x.idx)||st.fill(x.idx),dt.idx=st[0]),tt&&dt.live){for(let P=0;P<y.length;P++)(P>0||s==1&&!re)&&A_(P,st[P]);T_()}pt=!1,b!==!1&&Ti("setLegend")}i.setLegend=Jh;function A_(x,b){let P=y[x],L=x==0&&V==2?ji:t[x],B;re?B=P.values(i,x,b)??te:(B=P.value(i,b==null?null:L[b],x,b),B=B==null?te:{_:B}),dt.values[x]=B}function $s(x,b,P){Tf=ke,Af=Xe,[ke,Xe]=ut.move(i,ke,Xe),ut.left=ke,ut.top=Xe,mt&&(wr&&Wn(wr,xi(ke),0,U,Ct),Er&&Wn(Er,0,xi(Xe),U,Ct));let L,B=ii>ni;rs=Le,Ts=null;let Y=I.ori==0?U:Ct,at=I.ori==1?U:Ct;if(ke<0||Je==0||B){L=ut.idx=null;for(let ft=0;ft<y.length;ft++){let yt=se[ft];yt!=null&&Wn(yt,-10,-10,U,Ct)}Kt&&zn(null,Cr,!0,x==null&&hi.setSeries),dt.live&&(st.fill(L),pt=!0)}else{let ft,yt,Nt;s==1&&(ft=I.ori==0?ke:Xe,yt=Vn(ft,A),L=ut.idx=Tn(yt,t[0],ii,ni),Nt=G(t[0][L],I,Y,0));let Dt=-10,Ut=-10,ee=0,Se=0,ye=!0,de="",qt="";for(let Wt=s==2?1:0;Wt<y.length;Wt++){let ze=y[Wt],Qe=st[Wt],Ai=Qe==null?null:s==1?t[Wt][Qe]:t[Wt][1][Qe],Pe=ut.dataIdx(i,Wt,L,yt),ti=Pe==null?null:s==1?t[Wt][Pe]:t[Wt][1][Pe];if(pt=pt||ti!=Ai||Pe!=Qe,st[Wt]=Pe,Wt>0&&ze.show){let Qi=Pe==null?-10:Pe==L?Nt:G(s==1?t[0][Pe]:t[Wt][0][Pe],I,Y,0),zi=ti==null?-10:D(ti,s==1?M[ze.scale]:M[ze.facets[1].scale],at,0);if(Kt&&ti!=null){let fn=I.ori==1?ke:Xe,bn=vi(Ot.dist(i,Wt,Pe,zi,fn));if(bn<rs){let Hn=Ot.bias;if(Hn!=0){let tn=Vn(fn,ze.scale),pn=ti>=0?1:-1,wn=tn>=0?1:-1;wn==pn&&(wn==1?Hn==1?ti>=tn:ti<=tn:Hn==1?ti<=tn:ti>=tn)&&(rs=bn,Ts=Wt)}else rs=bn,Ts=Wt}}if(pt||Rt){let fn,bn;I.ori==0?(fn=Qi,bn=zi):(fn=zi,bn=Qi);let Hn,tn,pn,wn,Gn,Vi,en=!0,qs=lt.bbox;if(qs!=null){en=!1;let Hi=qs(i,Wt);pn=Hi.left,wn=Hi.top,Hn=Hi.width,tn=Hi.height}else pn=fn,wn=bn,Hn=tn=lt.size(i,Wt);if(Vi=lt.fill(i,Wt),Gn=lt.stroke(i,Wt),Rt)Wt==Ts&&rs<=Ot.prox&&(Dt=pn,Ut=wn,ee=Hn,Se=tn,ye=en,de=Vi,qt=Gn);else{let Hi=se[Wt];Hi!=null&&(Oe[Wt]=pn,ki[Wt]=wn,cp(Hi,Hn,tn,en),ap(Hi,Vi,Gn),Wn(Hi,_n(pn),_n(wn),U,Ct))}}}}if(Rt){let Wt=Ot.prox,ze=Xs==null?rs<=Wt:rs>Wt||Ts!=Xs;if(pt||ze){let Qe=se[0];Qe!=null&&(Oe[0]=Dt,ki[0]=Ut,cp(Qe,ee,Se,ye),ap(Qe,de,qt),Wn(Qe,_n(Dt),_n(Ut),U,Ct))}}}if(Be.show&&ws)if(x!=null){let[ft,yt]=hi.scales,[Nt,Dt]=hi.match,[Ut,ee]=x.cursor.sync.scales,Se=x.cursor.drag;if(wi=Se._x,Ei=Se._y,wi||Ei){let{left:ye,top:de,width:qt,height:Wt}=x.select,ze=x.scales[Ut].ori,Qe=x.posToVal,Ai,Pe,ti,Qi,zi,fn=ft!=null&&Nt(ft,Ut),bn=yt!=null&&Dt(yt,ee);fn&&wi?(ze==0?(Ai=ye,Pe=qt):(Ai=de,Pe=Wt),ti=M[ft],Qi=G(Qe(Ai,Ut),ti,Y,0),zi=G(Qe(Ai+Pe,Ut),ti,Y,0),Po(An(Qi,zi),vi(zi-Qi))):Po(0,Y),bn&&Ei?(ze==1?(Ai=ye,Pe=qt):(Ai=de,Pe=Wt),ti=M[yt],Qi=D(Qe(Ai,ee),ti,at,0),zi=D(Qe(Ai+Pe,ee),ti,at,0),Io(An(Qi,zi),vi(zi-Qi))):Io(0,at)}else tu()}else{let ft=vi(Tf-wf),yt=vi(Af-Ef);if(I.ori==1){let ee=ft;ft=yt,yt=ee}wi=Pi.x&&ft>=Pi.dist,Ei=Pi.y&&yt>=Pi.dist;let Nt=Pi.uni;Nt!=null?wi&&Ei&&(wi=ft>=Nt,Ei=yt>=Nt,!wi&&!Ei&&(yt>ft?Ei=!0:wi=!0)):Pi.x&&Pi.y&&(wi||Ei)&&(wi=Ei=!0);let Dt,Ut;wi&&(I.ori==0?(Dt=Tr,Ut=ke):(Dt=Ar,Ut=Xe),Po(An(Dt,Ut),vi(Ut-Dt)),Ei||Io(0,at)),Ei&&(I.ori==1?(Dt=Tr,Ut=ke):(Dt=Ar,Ut=Xe),Io(An(Dt,Ut),vi(Ut-Dt)),wi||Po(0,Y)),!wi&&!Ei&&(Po(0,0),Io(0,0))}if(Pi._x=wi,Pi._y=Ei,x==null){if(P){if(zf!=null){let[ft,yt]=hi.scales;hi.values[0]=ft!=null?Vn(I.ori==0?ke:Xe,ft):null,hi.values[1]=yt!=null?Vn(I.ori==1?ke:Xe,yt):null}No(ou,i,ke,Xe,U,Ct,L)}if(Kt){let ft=P&&hi.setSeries,yt=Ot.prox;Xs==null?rs<=yt&&zn(Ts,Cr,!0,ft):rs>yt?zn(null,Cr,!0,ft):Ts!=Xs&&zn(Ts,Cr,!0,ft)}}pt&&(dt.idx=L,Jh()),b!==!1&&Ti("setCursor")}let As=null;Object.defineProperty(i,"rect",{get(){return As==null&&Lo(!1),As}});function Lo(x=!1){x?As=null:(As=m.getBoundingClientRect(),Ti("syncRect",As))}function Pf(x,b,P,L,B,Y,at){ut._lock||ws&&x!=null&&x.movementX==0&&x.movementY==0||(jh(x,b,P,L,B,Y,at,!1,x!=null),x!=null?$s(null,!0,!0):$s(b,!0,!1))}function jh(x,b,P,L,B,Y,at,ft,yt){if(As==null&&Lo(!1),Zt(x),x!=null)P=x.clientX-As.left,L=x.clientY-As.top;else{if(P<0||L<0){ke=-10,Xe=-10;return}let[Nt,Dt]=hi.scales,Ut=b.cursor.sync,[ee,Se]=Ut.values,[ye,de]=Ut.scales,[qt,Wt]=hi.match,ze=b.axes[0].side%2==1,Qe=I.ori==0?U:Ct,Ai=I.ori==1?U:Ct,Pe=ze?Y:B,ti=ze?B:Y,Qi=ze?L:P,zi=ze?P:L;if(ye!=null?P=qt(Nt,ye)?a(ee,M[Nt],Qe,0):-10:P=Qe*(Qi/Pe),de!=null?L=Wt(Dt,de)?a(Se,M[Dt],Ai,0):-10:L=Ai*(zi/ti),I.ori==1){let fn=P;P=L,L=fn}}yt&&(b==null||b.cursor.event.type==ou)&&((P<=1||P>=U-1)&&(P=Zs(P,U)),(L<=1||L>=Ct-1)&&(L=Zs(L,Ct))),ft?(wf=P,Ef=L,[Tr,Ar]=ut.move(i,P,L)):(ke=P,Xe=L)}let Qh={width:0,height:0,left:0,top:0};function tu(){za(Qh,!1)}let If,Lf,Nf,Df;function Ff(x,b,P,L,B,Y,at){ws=!0,wi=Ei=Pi._x=Pi._y=!1,jh(x,b,P,L,B,Y,at,!0,!1),x!=null&&(ve(au,du,Uf,!1),No(tp,i,Tr,Ar,U,Ct,null));let{left:ft,top:yt,width:Nt,height:Dt}=Be;If=ft,Lf=yt,Nf=Nt,Df=Dt}function Uf(x,b,P,L,B,Y,at){ws=Pi._x=Pi._y=!1,jh(x,b,P,L,B,Y,at,!1,!0);let{left:ft,top:yt,width:Nt,height:Dt}=Be,Ut=Nt>0||Dt>0,ee=If!=ft||Lf!=yt||Nf!=Nt||Df!=Dt;if(Ut&&ee&&za(Be),Pi.setScale&&Ut&&ee){let Se=ft,ye=Nt,de=yt,qt=Dt;if(I.ori==1&&(Se=yt,ye=Dt,de=ft,qt=Nt),wi&&Es(A,Vn(Se,A),Vn(Se+ye,A)),Ei)for(let Wt in M){let ze=M[Wt];Wt!=A&&ze.from==null&&ze.min!=Le&&Es(Wt,Vn(de+qt,Wt),Vn(de,Wt))}tu()}else ut.lock&&(ut._lock=!ut._lock,$s(b,!0,x!=null));x!=null&&(gi(au,du),No(au,i,ke,Xe,U,Ct,null))}function R_(x,b,P,L,B,Y,at){if(ut._lock)return;Zt(x);let ft=ws;if(ws){let yt=!0,Nt=!0,Dt=10,Ut,ee;I.ori==0?(Ut=wi,ee=Ei):(Ut=Ei,ee=wi),Ut&&ee&&(yt=ke<=Dt||ke>=U-Dt,Nt=Xe<=Dt||Xe>=Ct-Dt),Ut&&yt&&(ke=ke<Tr?0:U),ee&&Nt&&(Xe=Xe<Ar?0:Ct),$s(null,!0,!0),ws=!1}ke=-10,Xe=-10,st.fill(null),$s(null,!0,!0),ft&&(ws=ft)}function Of(x,b,P,L,B,Y,at){ut._lock||(Zt(x),Co(),tu(),x!=null&&No(np,i,ke,Xe,U,Ct,null))}function kf(){T.forEach(Jv),F(i.width,i.height,!0)}js(el,kr,kf);let Pr={};Pr.mousedown=Ff,Pr.mousemove=Pf,Pr.mouseup=Uf,Pr.dblclick=Of,Pr.setSeries=(x,b,P,L)=>{let B=hi.match[2];P=B(i,b,P),P!=-1&&zn(P,L,!0,!1)},mt&&(ve(tp,m,Ff),ve(ou,m,Pf),ve(ep,m,x=>{Zt(x),Lo(!1)}),ve(ip,m,R_),ve(np,m,Of),yu.add(i),i.syncRect=Lo);let Va=i.hooks=n.hooks||{};function Ti(x,b,P){Bi?Re.push([x,b,P]):x in Va&&Va[x].forEach(L=>{L.call(null,i,b,P)})}(n.plugins||[]).forEach(x=>{for(let b in x.hooks)Va[b]=(Va[b]||[]).concat(x.hooks[b])});let Bf=(x,b,P)=>P,hi=di({key:null,setSeries:!1,filters:{pub:pp,sub:pp},scales:[A,y[1]?y[1].scale:null],match:[mp,mp,Bf],values:[null,null]},ut.sync);hi.match.length==2&&hi.match.push(Bf),ut.sync=hi;let zf=hi.key,eu=um(zf);function No(x,b,P,L,B,Y,at){hi.filters.pub(x,b,P,L,B,Y,at)&&eu.pub(x,b,P,L,B,Y,at)}eu.sub(i);function C_(x,b,P,L,B,Y,at){hi.filters.sub(x,b,P,L,B,Y,at)&&Pr[x](null,b,P,L,B,Y,at)}i.pub=C_;function P_(){eu.unsub(i),yu.delete(i),bi.clear(),mu(el,kr,kf),c.remove(),At?.remove(),Ti("destroy")}i.destroy=P_;function iu(){Ti("init",n,t),Ro(t||n.data,!1),H[A]?Yh(A,H[A]):Co(),nt=Be.show&&(Be.width>0||Be.height>0),et=pt=!0,F(n.width,n.height)}return y.forEach(yr),T.forEach(es),e?e instanceof HTMLElement?(e.appendChild(c),iu()):e(i,iu):iu(),i}Ii.assign=di;Ii.fmtNum=Au;Ii.rangeNum=il;Ii.rangeLog=rl;Ii.rangeAsinh=Eu;Ii.orient=tr;Ii.pxRatio=be;Ii.join=Hx;Ii.fmtDate=Cu,Ii.tzDate=Qx;Ii.sync=um;{Ii.addGap=Fv,Ii.clipGaps=ll;let n=Ii.paths={points:_m};n.linear=vm,n.stepped=kv,n.bars=Bv,n.spline=Vv}var jv=3,bm=n=>getComputedStyle(document.documentElement).getPropertyValue(n).trim(),$r=class{constructor(t,e,i){this.host=t,this.series=i,this.low=null,this.high=null;let s=()=>bm("--faint"),r={stroke:()=>bm("--line"),width:1},o="11px system-ui, sans-serif";this.uplot=new Ii({width:100,height:100,pxAlign:!1,cursor:{drag:{x:!1,y:!1},points:{size:6},sync:{key:"ropewalk"}},legend:{live:!0},scales:{x:{time:!1,auto:!1,range:(a,l,c)=>[l,c]},y:{range:()=>ty(this.low,this.high)}},axes:[{stroke:s,grid:r,ticks:{...r,size:4},font:o,size:24,values:(a,l)=>l.map(c=>`${Fe(c)} s`)},{stroke:s,grid:r,ticks:{...r,size:4},font:o,size:52,space:20,values:(a,l)=>l.map(c=>Ve(c,e))}],series:[{label:"time",value:(a,l)=>l===null?"":`${l.toFixed(2)} s`},...i.map(({label:a,colour:l})=>({label:a,stroke:l,width:1.6,points:{show:!1},gaps:ey,value:(c,h)=>h===null?"":Ve(h,e)}))]},[[],...i.map(()=>[])],t),this.resize()}resize(){let t=this.host.querySelector(".u-legend"),e=t instanceof HTMLElement?t.offsetHeight:24,i=this.host.clientWidth,s=Math.max(60,this.host.clientHeight-e-2);i>40&&(this.uplot.width!==i||this.uplot.height!==s)&&this.uplot.setSize({width:i,height:s})}show(t,e,i){[this.low,this.high]=Qv(t),this.uplot.batch(()=>{this.uplot.setData(t,!1),this.uplot.setScale("x",{min:e,max:i})})}destroy(){this.uplot.destroy()}};function Qv([,...n]){let[t,e]=[1/0,-1/0];for(let i of n)for(let s of i)Number.isFinite(s)&&(s<t&&(t=s),s>e&&(e=s));return t<=e?[t,e]:[null,null]}function ty(n,t){if(n===null||t===null||!Number.isFinite(n)||!Number.isFinite(t))return[0,1];let e=Math.max(.08*(t-n),.01*Math.max(Math.abs(n),Math.abs(t)),1e-9);return[n-e,t+e]}function ey(n,t,e,i){let[s,r]=[n.data[0],n.data[t]],o=a=>n.valToPos(s[a],"x",!0);return iy(s,r,e,i).map(([a,l])=>[o(a),o(l)])}function iy(n,t,e,i){let s=[],r=-1;for(let o=e;o<=i;o++)Number.isFinite(t[o])&&(r>=0&&(o>r+1||n[o]-n[r]>jv)&&s.push([r,o]),r=o);return s}function dl(n,t,e){let i=t.parts[0],s=n.scalars.map((c,h)=>[c,i.scalars[h]]),[r,o,a]=n.up,l=Yi(n,i,"speed_high");for(let c of e){let[h,d,u]=i.positions.subarray(3*c,3*c+3);s.push([`height ${c}`,h*r+d*o+u*a]),s.push([`speed ${c}`,i.speed[c]/65535*l]),s.push([`tension ${c}`,Xa(n,i,ny(n,c))])}return n.variants.slice(1).forEach((c,h)=>{s.push([`difference ${h+1}`,Yi(n,t.parts[h+1],"difference")])}),s}function ny(n,t){for(let{first:e,nodes:i}of n.variants[0].ropes)if(t>=e&&t<e+i)return Math.max(e,Math.min(t,e+i-2));return t}var Uu=[2,5,10,30,60,1/0],sy=66,wm={energies:"Energies",tension:"Tension",motion:"Height or speed",phase:"Phase plane",difference:"Difference"},ry=[["kinetic","kinetic",ei[0]],["gravity","gravity",ei[2]],["elastic","elastic",ei[1]],["lost","lost",ei[3]]],fl=class{constructor(t,e){this.stage=t,this.host=e,this.history=new Za,this.window=10,this.back=0,this.wanted=()=>{},this.quantity="height",this.panels=new Map,this.lastDraw=0,this.soon=!1,this.turn=0,this.plots=W("div",{className:"plots"}),this.chips=W("div",{className:"chips"}),this.scroll=W("input",{type:"range",id:"graph-scroll",min:"0",max:"0",step:"any","aria-label":"Scroll back in time",oninput:()=>{this.back=Number(this.scroll.max)-Number(this.scroll.value),this.drawAll()}}),this.windowChoice=W("select",{id:"graph-window","aria-label":"Seconds shown",onchange:()=>this.setWindow(Number(this.windowChoice.value.replace("all","Infinity")))},...Uu.map(s=>W("option",{value:Number.isFinite(s)?String(s):"all",selected:s===this.window},Number.isFinite(s)?`${s} s`:"all"))),this.quantityChoice=W("select",{id:"graph-quantity","aria-label":"Height or speed",onchange:()=>this.setQuantity()},W("option",{value:"height"},"Height"),W("option",{value:"speed"},"Speed")),e.append(W("div",{className:"graph-bar"},this.chips,this.quantityChoice,W("label",{},"Last",this.windowChoice),this.scroll),this.plots);let i=matchMedia("(max-width: 700px)").matches;this.shown=new Set(i?["energies"]:["energies","tension","motion"]),t.session.on("frame",s=>this.take(s)),t.session.on("layout",()=>this.rebuild()),t.session.on("status",()=>this.bounds()),new ResizeObserver(()=>this.resize()).observe(this.plots),this.plots.addEventListener("wheel",s=>this.wheel(s),{passive:!1})}get open(){return!this.host.hidden}toggle(t=!this.open){this.host.hidden=!t,t?this.rebuild():this.clear()}take(t){let{layout:e}=this.stage.session;if(!e)return;if(t.flags&2&&this.stage.session.hello?.mode==="replay"){this.drawSoon();return}if(this.history.add(t.time,dl(e,t,this.stage.marks.followed)),!this.open)return;if(!(t.flags&1)){this.drawSoon();return}let i=performance.now();if(i-this.lastDraw<sy/Math.max(1,this.panels.size))return;this.lastDraw=i;let s=[...this.panels.values()];this.turn=(this.turn+1)%Math.max(1,s.length),s[this.turn]&&this.draw(s[this.turn]),this.turn===0&&this.bounds()}clear(){for(let{plot:t,box:e}of this.panels.values())t instanceof $r&&t.destroy(),e.remove();this.panels.clear()}rebuild(){if(!this.open)return;this.clear();let t=(this.stage.session.layout?.variants.length??1)>1,e=Object.keys(wm).filter(i=>i!=="difference"||t);this.chips.replaceChildren(...e.map(i=>this.chip(i))),this.quantityChoice.hidden=!this.shown.has("motion");for(let i of e){if(!this.shown.has(i))continue;let s=W("div",{className:"plot",data:{kind:i}});this.plots.append(s),this.panels.set(i,{kind:i,box:s,plot:null})}for(let i of this.panels.values())i.plot=this.make(i);requestAnimationFrame(()=>this.resize()),this.bounds(),this.wanted()}get span(){return Number.isFinite(this.window)?this.window:Math.max(Uu[0],this.history.last-this.history.first)||Uu[0]}chip(t){return W("button",{type:"button",className:"chip","aria-pressed":String(this.shown.has(t)),data:{graph:t},onclick:()=>{matchMedia("(max-width: 700px)").matches&&this.shown.clear(),this.shown.delete(t)||this.shown.add(t),this.rebuild()}},wm[t])}make({kind:t,box:e}){if(t==="phase")return new Ka(e);let i={energies:"J",tension:"N",motion:this.quantity==="height"?"m":"m/s",difference:"m"}[t];return new $r(e,i,this.series(t))}series(t){if(t==="energies")return ry.map(([r,o,a])=>({name:r,label:o,colour:a}));let e=this.stage.session.layout?.variants??[];if(t==="difference")return e.slice(1).map((r,o)=>({name:`difference ${o+1}`,label:`${r.label}, rms`,colour:ei[(o+1)%ei.length]}));let i=t==="tension"?"tension":this.quantity,s=[...this.stage.marks.followed].map((r,o)=>({name:`${i} ${r}`,label:this.nodeName(r),colour:ei[(o+1)%ei.length]}));return t==="tension"?[{name:"tension_max",label:"largest",colour:ei[0]},...s]:this.quantity==="speed"?[{name:"speed_high",label:"fastest",colour:ei[0]},...s]:s.length?s:[{name:"high",label:"highest",colour:ei[0]},{name:"low",label:"lowest",colour:ei[5]}]}nodeName(t){let e=this.stage.session.layout?.variants[0].ropes??[],i=e.find(({first:s,nodes:r})=>t>=s&&t<s+r);return e.length>1&&i?`${i.name} ${t-i.zero}`:`node ${t-(i?.zero??0)}`}draw({kind:t,plot:e}){if(!Number.isFinite(this.history.last))return;let i=Math.max(this.history.last-this.back-this.span,this.history.first),s=i+this.span;if(e instanceof $r){let r=e.series.map(({name:o})=>o);e.show(this.history.between(i,s,r),i,s)}else if(e&&t==="phase"){let r=[...this.stage.marks.followed][0],[o,a]=this.history.between(i,s,[`height ${r}`]);e.show(o,a,ei[1])}}drawSoon(){this.soon||(this.soon=!0,requestAnimationFrame(()=>{this.soon=!1,this.bounds(),this.drawAll()}))}drawAll(){for(let t of this.panels.values())this.draw(t)}bounds(){let t=this.stage.session.status?.playing??!0,e=Math.max(0,this.history.last-this.history.first-this.span)||0;t&&(this.back=0),this.scroll.disabled=t||e===0,this.scroll.title=t?"Pause to scroll back":"Scroll back in time",this.scroll.max=String(e),this.scroll.value=String(e-this.back),t||this.drawAll()}wheel(t){if(this.scroll.disabled)return;t.preventDefault();let e=(t.deltaX||t.deltaY)/400*this.span;this.back=Math.min(Number(this.scroll.max),Math.max(0,this.back-e)),this.bounds()}setWindow(t){this.window=t,this.back=0,this.wanted(),this.bounds(),this.drawAll()}setQuantity(){this.quantity=this.quantityChoice.value,this.rebuild()}resize(){for(let{plot:t}of this.panels.values())t?.resize();this.drawAll()}};var pl=class{constructor(t,e){this.name=W("span",{className:"scene-name"},"…"),this.choose=W("button",{type:"button",className:"scene-choice",id:"open-scenes",title:"Scenes",onclick:e.scenes},this.name,mn("down")),this.tour=Di("tour","Guided tour",e.tour,{words:"Tour",id:"open-tour"}),this.compare=Di("compare","Compare copies",e.compare,{words:"Compare",id:"open-compare"}),this.keep=Di("keep","Save, export, link",()=>e.keep(this.keep),{words:"Keep",id:"open-keep"}),this.panel=Di("panel","Panel of constants",e.panel,{key:"P",id:"toggle-panel"}),t.append(W("strong",{className:"brand"},"Ropewalk"),this.choose,W("span",{className:"gap"}),this.tour,this.compare,this.keep,Di("help","Help",e.help,{key:"H",id:"open-help"}),Di("theme","Light or dark",e.theme,{key:"T",id:"toggle-theme"}),this.panel)}show(t){this.name.textContent=t,this.choose.setAttribute("aria-label",`Scene: ${t}. Choose another`),document.title=`${t} – Ropewalk`}};function Em(n){return n?n.bound===null?"The rope was moved farther in one step than the computation can follow. Try a shorter step.":n.stable?"The step is short enough for a rope at its length, so something pulled or threw a piece of it too far: a hand, a fast anchor, a heavy load. Be gentler, or take a shorter step.":"Each step was too long for so stiff and light a rope: within one step a piece of it flew past where its neighbours pull it back to, then farther past on the other side, and so on. A real rope would not do this; the computation did. A shorter step, softer springs or more mass keep it together.":"The rope has flown apart. Why is being looked at."}function Tm(n){if(!n||n.meter===null||n.meter_limit===null)return"";let{meter:t,meter_limit:e,meter_name:i}=n;return`The meter: ${i} = ${Fe(t)}, at most ${Fe(e)}.`}var oy=300,ay=3,ly={back:"Back to before",step:"Use the suggested step",implicit:"Use an implicit method",on:"Go on with these values"},ml=class{constructor(t,e,i){this.session=t,this.draw=i,this.timer=0,this.card=W("section",{className:"card broken",hidden:!0,role:"alert",id:"broken"}),e.append(this.card),t.on("broken",s=>this.show(s)),t.on("frame",({flags:s})=>this.tellReplay((s&2)!==0))}tellReplay(t){let{hello:e,layout:i}=this.session;e?.mode!=="replay"||this.card.hidden!==t||(this.card.hidden=!t,!(!t||!i?.broke)&&this.card.replaceChildren(W("h2",{},"The run broke"),W("p",{},i.broke.text||`It broke after t = ${Fe(i.broke.time)} s.`),W("p",{className:"faint"},"Shown: steps past the last good frame. No number counts them.")))}show(t){if(this.card.hidden=t===null,clearTimeout(this.timer),!t)return;let e=t.remedies.map((i,s)=>W("button",{type:"button",className:s===0?"main":"second",data:{remedy:i.id},onclick:()=>this.session.tell({type:"remedy",remedy:i.id})},i.label||ly[i.id]));this.card.replaceChildren(W("h2",{},"The simulation broke"),W("p",{className:"why"},Em(t.cause)),W("details",{},W("summary",{},"The theory, in numbers"),W("p",{},`${t.text} ${Tm(t.cause)}`)),W("div",{className:"row"},...e,...this.look(t)))}look(t){let{past:e}=t;if(!e?.length)return[];let i=W("span",{className:"faint",id:"past"}),s=o=>{let a=e[Math.min(o,e.length-1)],l=o===e.length+ay;this.draw(l?null:a.positions,t.variant),i.textContent=l?"":`${a.time.toFixed(5)} s: past the last good state`,l||(this.timer=window.setTimeout(()=>s(o+1),oy))};return[W("button",{type:"button",className:"second",id:"see-break",onclick:()=>{clearTimeout(this.timer),s(0)}},"See it break"),i]}};function gl(n){let t=[],e=0;for(let i of n.variants)t.push(e),e+=i.nodes;return t}var Ki=n=>n.variants.reduce((t,e)=>t+e.nodes,0);function qr(n,t,e){let i=n.variants.length>1?t:n.variants[t].ropes[e].color;return Ys(ei[i%ei.length])}function Am(n){let t=gl(n),e=[];return n.variants.forEach((i,s)=>{i.ropes.forEach((r,o)=>{e.push({name:r.name,first:t[s]+r.first,count:r.nodes,radius:r.diameter/2,spacing:r.length/Math.max(1,r.segments),colour:qr(n,s,o),loose:cy(i,r)})})}),{nodes:Ki(n),ropes:e}}function cy({anchors:n,loads:t},{first:e,nodes:i}){let s=new Set([...n,...t].map(({index:r})=>r));return[!s.has(e),!s.has(e+i-1)]}function Rm(n){let t=gl(n),e=new Uint8Array(Ki(n));return n.variants.forEach(({anchors:i,loads:s},r)=>{for(let{index:o}of[...i,...s])e[t[r]+o]=1}),e}function Cm(n,t,e,i){return n.variants.map((s,r)=>ui(e,t?r*i:0))}function Pm(n,t){let{low:e,high:i}=n,r=n.scale==="log"&&e>0?e*(i/e)**t:e+t*(i-e);return n.whole?Math.round(r):Number(r.toPrecision(3))}function Im(n,t){let{low:e,high:i}=n,r=n.scale==="log"&&e>0?Math.log(Math.max(t,e)/e)/Math.log(i/e):(t-e)/(i-e);return Math.min(1,Math.max(0,Number.isFinite(r)?r:0))}function er(n){let t=n.trim().replace(",",".").replace("−","-");return t===""?NaN:Number(t)}function Yr(n,t=11){let e=String(Number(n.toPrecision(6)));return e.length<=t?e:Number(n.toPrecision(t-5)).toExponential()}var hy=["bdf2","rk4"],uy=3,_l=class{constructor(t,e,i,s){this.stage=t,this.colours=s,this.changes=[],this.rows=W("div",{className:"compare-rows"}),this.fault=W("p",{className:"fault",hidden:!0,role:"alert"}),this.add=W("button",{type:"button",className:"second",onclick:()=>this.addRow()},"One more copy"),this.apart=W("select",{id:"compare-way","aria-label":"How copies are shown",onchange:()=>this.stage.setApart(this.apart.value==="apart")},W("option",{value:"over"},"overlaid"),W("option",{value:"apart"},"side by side")),this.stop=W("button",{type:"button",className:"second",id:"compare-end",onclick:()=>this.end()},"End the comparison"),this.window=Fr("Compare","compare",W("p",{},"Copies of this scene run beside it with one constant changed, moved by the same hand."),this.rows,this.fault,W("div",{className:"row"},this.add,W("span",{className:"gap"}),this.stop,W("button",{type:"button",className:"main",id:"compare-start",onclick:()=>this.start()},"Compare"))),e.append(this.window),this.lines=W("div",{}),this.card=W("div",{className:"card difference",hidden:!0,id:"difference"},W("div",{className:"row"},W("strong",{},"Copies"),this.apart,W("button",{type:"button",className:"second small",onclick:()=>this.end()},"End")),this.lines),i.append(this.card),t.card=()=>this.place(),this.lastShown=0,this.wasMany=!1,this.fresh=!1,t.session.on("layout",()=>this.layout()),t.session.on("frame",()=>this.show())}open(){this.changes.length||(this.changes=this.suggested()),this.fill(),this.stop.hidden=!this.wasMany,this.window.showModal()}suggested(){let{parameters:t,status:e,stability:i}=this.stage.session,s=t.find(c=>c.name==="method"),r=i[0]?.steps??{},o=(s?.choices??[]).map(({value:c})=>c),a=c=>(r[c]??1/0)>(e?.dt??0),l=hy.find(c=>c!==s?.value&&o.includes(c));return l&&a(l)?[{name:"method",value:l}]:e?[{name:"time_step",value:e.dt/2}]:[]}get choices(){return this.stage.session.parameters.filter(t=>t.kind!=="vector"&&t.enabled)}addRow(){let{status:t}=this.stage.session;this.changes.push({name:"time_step",value:t?t.dt/2:.001}),this.fill()}fill(){this.add.disabled=this.changes.length>=uy,this.rows.replaceChildren(...this.changes.map((t,e)=>this.row(t,e)))}row(t,e){let i=this.choices.find(o=>o.name===t.name)??this.choices[0],s=W("select",{"aria-label":`What copy ${e+1} changes`,onchange:()=>{let o=this.choices.find(a=>a.name===s.value);this.changes[e]={name:s.value,value:o?.value},this.fill()}},...this.choices.map(o=>W("option",{value:o.name,selected:o===i},o.label))),r=W("button",{type:"button",className:"second small","aria-label":`Remove copy ${e+1}`,onclick:()=>{this.changes.splice(e,1),this.fill()}},"Remove");return W("div",{className:"row"},s,this.valueField(i,t),r)}valueField(t,e){if(t.kind==="choice"||t.kind==="flag"){let s=t.choices??[!0,!1].map(o=>({value:o,label:o?"yes":"no"})),r=W("select",{"aria-label":t.label,onchange:()=>e.value=s[r.selectedIndex].value},...s.map(({value:o,label:a})=>W("option",{selected:o===e.value},a)));return r.selectedIndex>=0&&(e.value=s[r.selectedIndex].value),r}let i=W("input",{type:"text",inputMode:"decimal","aria-label":t.label,value:typeof e.value=="number"?Yr(e.value):"",oninput:()=>e.value=er(i.value)});return W("label",{},i,Nr(t.unit))}label({name:t,value:e}){let i=this.stage.session.parameters.find(s=>s.name===t);return i?.kind==="choice"||typeof e!="number"?String(e):`${i?.label??t} ${Ve(e,i?.unit)}`}async start(){let t=this.changes.map(e=>({label:this.label(e),changes:{[e.name]:e.value}}));try{await this.stage.session.ask({type:"compare",variants:t}),this.fault.hidden=!0,this.window.close()}catch(e){this.fault.textContent=e.text,this.fault.hidden=!1}}async end(){this.window.close(),await this.stage.session.tell({type:"compare",variants:[]})}layout(){let t=this.stage.session.layout,e=t.variants.length>1;this.card.hidden=!e,e!==this.wasMany&&this.colours(e),e&&!this.wasMany&&(this.fresh=!0),this.wasMany=e,this.lines.replaceChildren(...t.variants.map((i,s)=>{let r=W("i",{});return r.style.background=Ye(qr(t,s,0)),W("div",{className:"line"},r,W("span",{},i.label),W("output",{}))}))}place(){if(!this.card.getClientRects().length)return null;let{x:t,y:e,width:i,height:s}=this.card.getBoundingClientRect(),r=this.stage.renderer.canvas.getBoundingClientRect();return new DOMRect(t-r.x,e-r.y,i,s)}show(){let{layout:t,frame:e}=this.stage.session,i=performance.now();!t||!e||this.card.hidden||i-this.lastShown<200&&!this.fresh||(this.lastShown=i,e.parts.forEach((s,r)=>{let o=this.lines.children[r]?.querySelector("output");if(!o||r===0)return;let a=Ve(Yi(t,s,"difference"),"m"),l=Ve(Yi(t,s,"difference_max"),"m");o.textContent=`differs by ${a} rms, ${l} at most`}),this.fresh&&this.stage.uncover(),this.fresh=!1)}};var dy=100,Ou=[.01,.02,.05,.1,.2,.5,1,2,4],Lm=n=>n>=.995?`${Fe(n)}×`:`1/${Fe(1/n)}×`,xl=class{constructor(t,e,i){this.session=t,this.reset=Di("reset","Reset to time zero",()=>this.doReset(),{key:"R",id:"reset"}),this.play=Di("play","Play",()=>this.toggle(),{key:"space",id:"play",kind:"main"}),this.step=Di("step","One step",()=>this.doStep(),{key:"full stop",id:"step"}),this.clock=W("output",{id:"clock",title:"Simulated time"},"0.00 s"),this.speed=W("input",{type:"range",id:"speed",min:"0",max:String(Ou.length-1),step:"1","aria-label":"Speed",oninput:()=>this.setSpeed()}),this.speedText=W("output",{id:"speed-text"},"1×"),this.reached=W("output",{id:"realtime",className:"faint"},""),this.seek=W("input",{type:"range",id:"seek",min:"0",max:"1",step:"any","aria-label":"Time in the recording",oninput:()=>this.doSeek()}),this.graphs=Di("graph","Graphs",i,{words:"Graphs",key:"G",id:"toggle-graphs"}),this.seeking=0,this.shown=-1/0,e.append(W("div",{className:"group"},this.reset,this.play,this.step),this.clock,this.seek,W("label",{className:"speed",title:"Speed, as a part of real time"},"Speed",this.speed,this.speedText),this.reached,W("span",{className:"gap"}),this.graphs),t.on("hello",()=>this.refresh()),t.on("status",()=>this.refresh()),t.on("frame",s=>this.showTime(s.time)),this.refresh()}refresh(){let{session:t}=this,{status:e}=t;this.play.hidden=!t.can("play"),this.step.hidden=!t.can("step"),this.reset.hidden=!t.can("reset");let i=this.speed.parentElement;if(i.hidden=!t.can("speed"),this.seek.hidden=!t.can("seek")||!e?.duration,!e)return;!e.playing&&t.frame&&this.showTime(t.frame.time),this.play.disabled=e.broken,this.step.disabled=e.broken||e.playing;let s=e.playing?"pause":"play";if(this.play.dataset.shows!==s){this.play.dataset.shows=s,this.play.replaceChildren(mn(s,s==="play"));let r=e.playing?"Pause":"Play";this.play.title=`${r} (space)`,this.play.setAttribute("aria-label",r)}document.activeElement!==this.speed&&(this.speed.value=String(fy(e.speed))),this.speedText.textContent=Lm(e.speed),this.reached.textContent=e.playing?`reached ${Fe(e.realtime)}×`:"paused",this.reached.classList.toggle("slow",e.slow),this.reached.title=e.text||"Simulated time per real time, over the last half second",e.duration&&(this.seek.max=String(e.duration))}showTime(t){let e=performance.now();if(e-this.shown>=dy||!this.session.status?.playing){this.shown=e;let i=`${t.toFixed(2)} s`;this.clock.textContent!==i&&(this.clock.textContent=i)}!this.seek.hidden&&document.activeElement!==this.seek&&(this.seek.value=String(t))}toggle(){let{status:t}=this.session;!t||t.broken||!this.session.can("play")||this.session.tell({type:t.playing?"pause":"play"})}async doStep(){let{status:t}=this.session;!t||t.broken||!this.session.can("step")||(t.playing?await this.session.tell({type:"pause"}):await this.session.tell({type:"step"}))}doReset(){this.session.can("reset")&&this.session.tell({type:"reset"})}setSpeed(){let t=Ou[Number(this.speed.value)];this.speedText.textContent=Lm(t),this.session.tell({type:"speed",value:t})}doSeek(){cancelAnimationFrame(this.seeking),this.seeking=requestAnimationFrame(()=>{this.session.send({type:"seek",time:Number(this.seek.value)})})}};function fy(n){let t=Ou.map(e=>Math.abs(Math.log(e/n)));return t.indexOf(Math.min(...t))}var py=[["Drag an anchor (a ring)","it follows the hand, in the plane of a flat scene, else parallel to the screen"],["Drag the rope","by a soft spring; its force is shown in newtons"],["Hold Shift at the end of a drag","the spring stays; double-click on empty space lets go"],["Right-click, or a long press","pin, cut, load, kick, follow"],["Drag empty space","turn the view; with Shift, the right button or near a rope: shift it"],["Wheel, or two fingers","zoom"]],my=[["← → ↑ ↓","move the first anchor at 3 m/s"],["Home, End","move it away from you, towards you"],["A D W S Q E","the same for the second anchor"],["J L I K U O","the same for the third anchor"],["Tab, Enter","on the scene: the next place on the ropes, its menu"],["Space","play or pause"],[".","one step"],["R","reset to time zero"],["F","show everything"],["G","graphs"],["P","panel of constants"],["T","light or dark"],["H or ?","this help"]],vl=class{constructor(t){let e=(i,s)=>W("dl",{},...i.flatMap(([r,o])=>[W("dt",{},W(s,{},r)),W("dd",{},o)]));this.version=W("p",{className:"faint"}),this.window=Fr("Help","help",W("div",{className:"columns"},W("section",{},W("h3",{},"Hand"),e(py,"span")),W("section",{},W("h3",{},"Keys"),e(my,"kbd"))),this.version),t.append(this.window)}open(){this.window.open?this.window.close():this.window.showModal()}};var gy={"nodes.csv":"Table of nodes (CSV)","energies.csv":"Table of energies (CSV)","tension.csv":"Table of tension (CSV)","scene.toml":"Scene (TOML)","page.html":"Page that replays it (HTML)"},yl=class{constructor(t,e,i){this.stage=t,this.host=e,this.notices=i}open(t){let{session:e}=this.stage,{base:i}=e.source,{hello:s}=e,r=[{label:"Save the run",id:"keep-save",hint:s?.folder??"",show:e.can("save"),press:()=>this.save()},{label:"Copy the link to this set-up",id:"keep-link",show:e.can("scene"),press:()=>this.copyLink()},{label:"Picture (PNG)",id:"keep-png",show:!0,press:()=>this.picture()},...(s?.exports??[]).map(l=>({label:gy[l]??l,id:`keep-${l.replace(".","-")}`,show:!0,press:()=>this.file(`${i}export/${l}`,l)}))],o=t.getBoundingClientRect(),a=this.host.getBoundingClientRect();ko(this.host,o.right-a.left-240,o.bottom-a.top+4,r.filter(({show:l})=>l),"Keep")}async save(){await this.stage.session.tell({type:"save"})}async file(t,e){this.notices.say(`Making ${e} …`);try{let i=await fetch(t);if(!i.ok)throw new Error(i.status===404?"it cannot be made here":await i.text());let s=URL.createObjectURL(await i.blob());su(s,e),setTimeout(()=>URL.revokeObjectURL(s),1e4),this.notices.say(`${e} is in your downloads.`)}catch(i){this.notices.say(`${e}: ${i instanceof Error?i.message:i}`,"fault")}}picture(){this.stage.draw(!0),this.stage.renderer.canvas.toBlob(t=>{if(!t)return;let e=URL.createObjectURL(t);su(e,`${_y(this.stage.session.layout?.scene.name??"rope")}.png`),setTimeout(()=>URL.revokeObjectURL(e),1e4)})}async copyLink(){let t=this.stage.session.status,e=`${location.href.split("#")[0]}${t?.address?`#${t.address}`:""}`;try{await navigator.clipboard.writeText(e),this.notices.say("The link is copied. It opens this scene with these constants.")}catch{this.notices.say(e)}}},_y=n=>n.toLowerCase().replace(/[^a-z0-9]+/g,"-").replace(/^-|-$/g,"")||"rope";function Nm([n,t],[e,i],[s,r],o){let a=Math.hypot(e,i),[l,c]=a>1?[e/a,i/a]:[1,0],h=5+Math.min(s/2/Math.abs(l||1e-9),r/2/Math.abs(c||1e-9)),d=[n+l*h,t+c*h],u=s/2+15,f=r/2+15,m=[d,[d[0],d[1]-r],[d[0],d[1]+r],[n,t-f],[n,t+f],[n+u,t],[n-u,t],[n,t-f-1.5*r],[n,t+f+1.5*r]],v=(g,p)=>Math.max(2,Math.min(g,p-2));return m.map(([g,p])=>({x:v(g-s/2,o[0]-s),y:v(p-r/2,o[1]-r),width:s,height:r}))}function ku(n,t,e){return!t.some(i=>xy(n,i))&&!e.some(([i,s])=>i>n.x&&i<n.x+n.width&&s>n.y&&s<n.y+n.height)}function xy(n,t){return n.x<t.x+t.width&&t.x<n.x+n.width&&n.y<t.y+t.height&&t.y<n.y+n.height}var vy=7.4,yy=22,My=18,Sy=2.5,by=600,wy=10,Ey=90,Ty=".toolbar, .legend, .difference, .tour, .broken, .slow-note, .banner",Ay=100,Ry=1e3,Ml=class{constructor(t,e){this.stage=t,this.host=e,this.box=W("div",{className:"labels","aria-hidden":"true"}),this.pool=[],this.taken=[],this.since=[],this.cards=[],this.watched=new Set,this.looked=this.worded=-1/0,this.watch=new ResizeObserver(()=>{this.looked=-1/0,t.marks.dirty=!0}),this.watch.observe(e),e.append(this.box),t.afterDraw.push(()=>this.refresh())}refresh(){let{labels:t}=this.stage.marks;for(;this.pool.length<t.length;){let a=W("span",{});this.pool.push(a),this.box.append(a)}let e=t.flatMap(({from:a,at:l})=>[this.plate(a,wy),this.plate(l,Sy)]),i=t.length?[...this.cardsNow(),...e]:[],s=t.length?this.beads():[],r=performance.now(),o=r-this.worded>=Ay||!this.stage.session.status?.playing;o&&(this.worded=r),this.pool.forEach((a,l)=>{let c=t[l],d=o||a.hidden||a.className!==c?.kind?c?.text:a.textContent,u=c?this.place({...c,text:d??""},l,i,s):null;a.hidden===(u!==null)&&(a.hidden=!a.hidden),u&&(i.push(u),a.textContent!==d&&(a.textContent=d??""),a.className!==c.kind&&(a.className=c.kind),a.style.transform=`translate(${Math.round(u.x)}px, ${Math.round(u.y)}px)`)})}place({from:t,at:e,text:i},s,r,o){let{camera:a}=this.stage,[l,c,h]=a.project(...e);if(!(h>0))return null;let[d,u]=a.project(...t),f=[vy*i.length+My,yy],m=[a.width,a.height],v=Nm([l,c],[l-d,c-u],f,m),g=this.taken[s]??0,p=performance.now(),y=p-(this.since[s]??-1/0)<by?[g,...v.keys()]:[...v.keys()],M=y.find(R=>ku(v[R],r,o))??y.find(R=>ku(v[R],r,[]));return M===void 0?null:(M!==g&&(this.since[s]=p),this.taken[s]=M,v[M])}plate(t,e){let[i,s]=this.stage.camera.project(...t);return{x:i-e,y:s-e,width:2*e,height:2*e}}beads(){let{camera:t,nodes:e,session:i}=this.stage,s=i.layout?Ki(i.layout):0,r=Math.max(1,Math.ceil(s/Ey)),o=[];for(let a=0;a<s;a+=r){let[l,c,h]=e.shown.subarray(4*a,4*a+3);o.push(t.project(l,c,h))}return o}cardsNow(){let t=performance.now();if(t-this.looked<Ry)return this.cards;this.looked=t;let{left:e,top:i}=this.host.getBoundingClientRect();return this.cards=[...this.host.querySelectorAll(Ty)].map(s=>{this.watched.has(s)||this.watch.observe(s),this.watched.add(s);let{x:r,y:o,width:a,height:l}=s.getBoundingClientRect();return{x:r-e,y:o-i,width:a,height:l}}),this.cards}};var Cy=100,Py=2e-9;function Iy(n,t){return n==="strain"?["%",100]:n==="speed"?["m/s",1]:t>=1e7?["MN",1e-6]:t>=1e4?["kN",.001]:["N",1]}var Sl=class{constructor(t,e){this.stage=t,this.written=-1/0,this.select=W("select",{id:"colouring","aria-label":"Colour of the ropes",onchange:()=>this.choose()},W("option",{value:"tension"},"Tension"),W("option",{value:"strain"},"Tension / EA"),W("option",{value:"speed"},"Speed"),W("option",{value:"plain"},"Plain colours")),this.bar=W("div",{className:"map"}),this.dark=null,this.low=W("span",{}),this.middle=W("span",{}),this.high=W("span",{}),this.numbers=W("div",{className:"numbers",id:"legend-numbers"},this.low,this.middle,this.high),this.ropes=W("div",{className:"rope-names"}),this.arrows=this.check("Forces","show-forces",!0,i=>t.marks.reactions=i),this.dots=this.check("Nodes","show-nodes",!1,i=>t.dots=i),this.posts=this.check("Posts","show-posts",!0,i=>t.marks.standing=i),this.posts.className="posts",this.grid=W("span",{}),this.thick=W("span",{}),e.append(W("div",{className:"card legend"},this.select,this.bar,this.numbers,this.ropes,W("div",{className:"row"},this.arrows,this.dots,this.posts),W("div",{className:"numbers drawn-as"},this.grid,this.thick))),t.session.on("layout",()=>this.names()),t.session.on("status",()=>this.refresh()),t.afterDraw.push(()=>{(!t.session.status?.playing||performance.now()-this.written>=Cy)&&this.refresh()})}check(t,e,i,s){let r=W("input",{type:"checkbox",id:e,checked:i,onchange:()=>{s(r.checked),this.stage.dirty=!0}});return W("label",{},r,t)}choose(){this.stage.setColouring(this.select.value),this.names()}names(){this.written=-1/0;let{layout:t}=this.stage.session,e=this.stage.colouring==="plain";if(this.bar.hidden=this.numbers.hidden=e,this.ropes.replaceChildren(),!t||!e)return;let s=t.variants.length>1?t.variants.map((r,o)=>({name:r.label,colour:qr(t,o,0)})):t.variants[0].ropes.map((r,o)=>({name:r.name,colour:qr(t,0,o)}));for(let{name:r,colour:o}of s.slice(0,6)){let a=W("i",{});a.style.background=Ye(o),this.ropes.append(W("span",{},a,r))}s.length>6&&this.ropes.append(W("span",{className:"faint"},`and ${s.length-6} more`))}paint(){let{dark:t}=this.stage.theme;if(t===this.dark)return;this.dark=t;let e=Dr(t),i=Array.from({length:17},(s,r)=>Ye(e[Math.round(r/16*(e.length-1))]));this.bar.style.backgroundImage=`linear-gradient(to right, ${i.join(", ")})`}refresh(){this.paint(),this.written=performance.now();let{range:t,colouring:e}=this.stage,{low:i,high:s}=t,[r,o]=Iy(e,Math.max(Math.abs(i),Math.abs(s))),a=c=>Fe(Number((c*o).toPrecision(2))),l=s-i>Py;if(this.low.hidden=this.middle.hidden=!l,!l)return Zr(this.high,`${a(i)} ${r}`),this.showGrid();Zr(this.low,a(i)),Zr(this.middle,a((i+s)/2)),Zr(this.high,`${a(s)} ${r}`),this.showGrid()}showGrid(){Zr(this.grid,`Grid ${Ve(this.stage.spacing,"m")}`);let t=this.stage.thickness();Zr(this.thick,t>1.05?`Drawn ${Fe(Number(t.toPrecision(2)))}× thick`:"True thickness")}};function Zr(n,t){n.textContent!==t&&(n.textContent=t)}var qo=1.25,bl=class{constructor(t,e){this.session=t,this.host=e,t.on("stability",i=>this.show(i)),t.on("layout",()=>this.show(t.stability))}show(t){let e=t.length>1;this.host.hidden=t.length===0,this.host.classList.toggle("many",e),this.host.replaceChildren(...t.map((i,s)=>this.row(i,s,e)))}row(t,e,i){let{ratio:s,zone:r}=t,o=this.session.layout?.variants[e]?.label,a=W("div",{className:"fill"});a.style.width=`${100*Math.min(1,(s??0)/qo)}%`;let l=W("div",{className:"tick"});l.style.left=`${100/qo}%`;let c=W("div",{className:"amber-zone"});c.style.left=`${90/qo}%`,c.style.width=`${10/qo}%`;let h=W("div",{className:"red-zone"});h.style.left=`${100/qo}%`;let d=W("div",{className:"meter-bar",role:"meter","aria-label":"Step as a part of the largest stable step","aria-valuemin":"0","aria-valuemax":"1.25","aria-valuenow":String(s??0)},a,c,h,l),u=[];return t.bound!==null&&u.push([`largest step ${Ve(t.bound,"s")}`,"step"]),t.largest_spring_constant!==null?u.push([`largest spring constant ${Ve(t.largest_spring_constant,"N/m")}`,"k"]):t.largest_axial_stiffness!==null&&u.push([`largest EA ${Ve(t.largest_axial_stiffness,"N")}`,"k"]),W("div",{className:`meter-row ${r}`,title:t.verdict,data:{zone:r}},W("span",{className:"meter-name"},i&&o?o:"Stability"),d,W("strong",{className:"meter-ratio"},s===null||t.bound===null?"no bound":Ly(s)),...u.map(([f,m])=>W("span",{className:`meter-fact ${m}`},f)))}};function Ly(n){return n>=10?`${Fe(n)} times the bound`:`${Fe(100*n)} % of the bound`}var Ny=7e3,Dy=3,wl=class{constructor(t,e){this.list=W("div",{className:"notices","aria-live":"polite"}),this.banner=W("div",{className:"banner",hidden:!0,role:"alert",id:"banner"}),this.slow=W("div",{className:"slow-note",hidden:!0,id:"slow"}),e.append(this.banner,this.slow,this.list),t.on("error",i=>this.say(i.text,"fault")),t.on("note",({text:i})=>this.say(i)),t.on("saved",({folder:i})=>this.say(`Saved in ${i}`)),t.on("connection",({state:i,text:s})=>this.connection(i,s)),t.on("status",({slow:i,text:s,broken:r})=>{let o=i&&s!==""&&!r;this.slow.hidden=!o,o&&this.slow.textContent!==s&&(this.slow.textContent=s)})}connection(t,e){if(this.banner.hidden=t==="open",this.banner.classList.toggle("calm",t==="waiting"),document.documentElement.dataset.connection=t,t!=="open")if(t==="damaged")this.banner.replaceChildren(e);else{let i=t==="waiting"?"":" Trying again …";this.banner.replaceChildren(W("span",{className:"spinner"}),`${e}${i}`)}}say(t,e="note"){for(let r of this.list.children)r.firstChild?.textContent===t&&r.remove();let i=W("button",{type:"button",className:"plain","aria-label":"Close",onclick:()=>s.remove()},mn("close")),s=W("div",{className:`notice ${e}`},W("span",{},t),i);for(this.list.append(s);this.list.children.length>Dy;)this.list.firstChild?.remove();setTimeout(()=>s.remove(),Ny)}};var El=class{constructor(t,e){this.session=t,this.list=W("div",{className:"scene-themes"}),this.window=Fr("Scenes","scenes",this.list),e.append(this.window),t.on("presets",()=>this.fill()),t.on("layout",()=>this.mark())}open(){this.mark(),this.window.showModal()}fill(){let{presets:t}=this.session,e=[...new Set(t.map(({theme:i})=>i))];this.list.replaceChildren(...e.flatMap(i=>[W("h3",{},i),W("div",{className:"scene-list"},...t.filter(s=>s.theme===i).map(s=>this.card(s)))])),this.mark()}card(t){let{base:e}=this.session.source,i=W("div",{className:"picture"});return t.picture&&e&&(i.style.maskImage=`url("${new URL(e+t.picture,location.href.split(/[?#]/)[0]).href}")`),W("button",{type:"button",className:"scene-card",data:{preset:t.name},onclick:()=>this.choose(t.name)},i,W("strong",{},t.title),W("span",{},t.sentence))}mark(){let t=this.session.layout?.scene.preset;for(let e of this.list.querySelectorAll(".scene-card"))e instanceof HTMLElement&&e.classList.toggle("now",e.dataset.preset===t)}async choose(t){this.window.close(),await this.session.tell({type:"scene",preset:t})&&this.session.send({type:"play"})}};var Dm=[["hand","hand","Hand: drag anchors and ropes",""],["pin","pin","Pin: hold a node where it is, or let it go again","pin"],["cut","cut","Cut a segment","cut"],["load","load","Hang a load on a node","load"],["kick","kick","Kick: draw the velocity from a node","kick"],["follow","follow","Follow a node: its trail and its graphs",""]],Tl=class{constructor(t,e,i){this.stage=t,this.host=e,this.follow=i,this.pointer=null,this.mass=1,this.buttons=new Map,this.bar=W("div",{className:"toolbar",role:"toolbar","aria-label":"Tools"});for(let[s,r,o]of Dm){let a=Di(r,o,()=>this.choose(s),{id:`tool-${s}`});this.buttons.set(s,a),this.bar.append(a)}this.massField=W("input",{type:"text",inputMode:"decimal",value:"1",id:"load-mass","aria-label":"Mass to hang [kg]",onchange:()=>{let s=er(this.massField.value);s>=0&&(this.mass=s),this.massField.value=String(this.mass)}}),this.massBox=W("label",{className:"mass",hidden:!0},this.massField,"kg"),this.bar.append(this.massBox),e.append(this.bar),t.session.on("hello",()=>this.refresh()),this.refresh()}refresh(){for(let[t,,,e]of Dm){let i=this.buttons.get(t);i&&(i.hidden=e!==""&&!this.stage.session.can(e))}this.choose(this.pointer?.tool??"hand")}choose(t){this.pointer&&(this.pointer.tool=t);for(let[e,i]of this.buttons)i.setAttribute("aria-pressed",String(e===t));this.massBox.hidden=t!=="load",this.host.dataset.tool=t}use(t,e){let{session:i}=this.stage;t==="pin"?e.kind==="anchor"?i.tell({type:"unpin",anchor:e.anchor}):i.tell({type:"pin",node:e.node}):t==="cut"?i.tell({type:"cut",segment:e.segment}):t==="load"?i.tell({type:"load",node:e.node,mass:this.mass}):t==="follow"&&this.follow(e.node)}menu(t,e,i){let{session:s,marks:r}=this.stage;if(!t){ko(this.host,e,i,[{label:"Show everything",press:()=>this.stage.fit()},{label:"Let go of everything",press:()=>s.send({type:"let_go"}),disabled:!s.can("let_go")}]);return}let{node:o}=t,l=(s.layout?.variants[0].loads.filter(f=>f.index===o)??[]).reduce((f,m)=>f+m.mass,0),c=this.stage.camera.up,d=[t.kind==="anchor"?{label:"Let this node go",command:"unpin",press:()=>s.tell({type:"unpin",anchor:t.anchor})}:{label:"Pin it here",command:"pin",press:()=>s.tell({type:"pin",node:o})},{label:"Cut here",command:"cut",press:()=>s.tell({type:"cut",segment:t.segment})},...[1,10].map(f=>({label:`Hang ${f} kg here`,command:"load",press:()=>s.tell({type:"load",node:o,mass:f})})),...l>0?[{label:`Take the load off (${Fe(l)} kg)`,command:"load",press:()=>s.tell({type:"load",node:o,mass:0})}]:[],{label:"Kick it up (5 m/s)",command:"kick",press:()=>s.tell({type:"kick",node:o,velocity:ui(c,5)})}].filter(f=>s.can(f.command)),u=r.followed.has(o);ko(this.host,e,i,[...d,{label:u?"Stop following":"Follow: trail and graphs",press:()=>this.follow(o)}],t.kind==="anchor"?`Anchor ${t.anchor}`:this.nodeName(t))}nodeName(t){let e=this.stage.session.layout?.variants[t.variant].ropes??[],i=e.find(({first:s,nodes:r})=>t.node>=s&&t.node<s+r);return i?`Node ${t.node-i.zero}${e.length>1?` of ${i.name}`:""}`:`Node ${t.node}`}};var Fy=["r4","hanging-rope"],Uy=2,Fm="bdf2",Yo=[{title:"Hang it",text:"A rope is a chain of masses and springs. Let it hang and swing: its colour is the tension in newtons.",act:"Hang the rope",press:n=>n.hang(),done:({session:n,hung:t})=>t&&(n.frame?.time??0)>1},{title:"Move it",text:"Take an anchor, one of the squares, and move it. The arrow keys do it too, at 3 m/s. Then pull at the rope itself.",act:"",press:()=>{},done:({moved:n})=>n},{title:"Stiffen it until it breaks",text:"Make the springs stiffer and watch the meter: beyond the red line every step overshoots, nodes jump to and fro, and the rope breaks.",act:"Twice as stiff",press:n=>n.stiffen(),done:({session:n})=>n.broken!==null},{title:"Make the step smaller",text:"Nothing is wrong with the rope: the time step is too long for springs so stiff. A shorter step mends it, and costs more computing.",act:"Use a shorter step",press:n=>n.shorten(),done:({session:n})=>n.broken===null&&n.stability[0]?.stable===!0},{title:"Take an implicit method",text:"An implicit method solves for the next state and bears any stiffness with long steps. The meter has no red any more.",act:"Use an implicit method",press:n=>n.implicit(),done:({session:n})=>n.stability[0]?.bound===null}],Al=class{constructor(t,e){this.session=t,this.at=-1,this.hung=this.moved=!1,this.card=W("section",{className:"card tour",hidden:!0,"aria-label":"Guided tour",id:"tour"}),e.append(this.card),t.on("status",()=>this.check()),t.on("stability",()=>this.check()),t.on("broken",()=>this.check())}start(){if(this.at>=0){this.end();return}this.hung=this.moved=!1,this.go(0)}end(){this.at=-1,this.card.hidden=!0}handMoved(){this.moved||(this.moved=!0,this.check())}go(t){if(this.at=t,t>=Yo.length){this.end();return}let{title:e,text:i,act:s,press:r}=Yo[t],o=t===Yo.length-1;t===1&&(this.moved=!1);let a=t!==4||this.implicitMethod()!==null,l=W("button",{type:"button",className:"plain close","aria-label":"End the tour",onclick:()=>this.end()},mn("close"));this.card.replaceChildren(W("header",{},W("small",{},`Step ${t+1} of ${Yo.length}`),l),W("h2",{},e),W("p",{},i),a?"":W("p",{className:"faint"},"This version has no implicit method yet; a Runge-Kutta method bears a longer step."),W("div",{className:"row"},s!==""?W("button",{type:"button",className:"main",id:"tour-act",disabled:!a,onclick:()=>r(this)},s):"",W("span",{className:"gap"}),t>0?W("button",{type:"button",className:"second",onclick:()=>this.go(t-1)},"Back"):"",W("button",{type:"button",className:"second",id:"tour-next",onclick:()=>this.go(t+1)},o?"Finish":"Next"))),this.card.hidden=!1,this.check()}check(){if(this.at<0)return;let t=Yo[this.at].done(this);this.card.classList.toggle("done",t);let e=this.card.querySelector("#tour-next");e&&(e.className=t?"main":"second")}async hang(){let{session:t}=this,e=Fy.find(i=>t.presets.some(s=>s.name===i))??t.presets[0]?.name;e&&t.can("scene")&&await t.tell({type:"scene",preset:e}),this.hung=!0,await t.tell({type:"play"})}async stiffen(){let{session:t}=this,e=t.parameters.find(i=>i.name==="spring_constant")??t.parameters.find(i=>i.name==="EA");!e||typeof e.value!="number"||(await t.tell({type:"set",name:e.name,value:e.value*Uy}),t.status?.playing||await t.tell({type:"play"}))}async shorten(){let{session:t}=this;t.broken?await t.tell({type:"remedy",remedy:"step"}):await t.tell({type:"set",name:"time_step",value:"auto"}),await t.tell({type:"play"})}implicitMethod(){let e=this.session.parameters.find(s=>s.name==="method")?.choices??[];if(e.some(({value:s})=>s===Fm))return Fm;let i=e.find(({value:s,label:r})=>/implicit|sdirk|bdf|midpoint/i.test(`${s} ${r}`)&&!/semi-implicit/i.test(`${s}`));return i?i.value:null}async implicit(){let t=this.implicitMethod();t!==null&&(this.session.broken?await this.session.tell({type:"remedy",remedy:"implicit"}):await this.session.tell({type:"set",name:"method",value:t}),await this.session.tell({type:"play"}))}};var Xn=class n{constructor(t,e,i,s,r="div"){this.parent=t,this.object=e,this.property=i,this._disabled=!1,this._hidden=!1,this.initialValue=this.getValue(),this.domElement=document.createElement(r),this.domElement.classList.add("lil-controller"),this.domElement.classList.add(s),this.$name=document.createElement("div"),this.$name.classList.add("lil-name"),n.nextNameID=n.nextNameID||0,this.$name.id=`lil-gui-name-${++n.nextNameID}`,this.$widget=document.createElement("div"),this.$widget.classList.add("lil-widget"),this.$disable=this.$widget,this.domElement.appendChild(this.$name),this.domElement.appendChild(this.$widget),this.domElement.addEventListener("keydown",o=>o.stopPropagation()),this.domElement.addEventListener("keyup",o=>o.stopPropagation()),this.parent.children.push(this),this.parent.controllers.push(this),this.parent.$children.appendChild(this.domElement),this._listenCallback=this._listenCallback.bind(this),this.name(i)}name(t){return this._name=t,this.$name.textContent=t,this}onChange(t){return this._onChange=t,this}_callOnChange(){this.parent._callOnChange(this),this._onChange!==void 0&&this._onChange.call(this,this.getValue()),this._changed=!0}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(){this._changed&&(this.parent._callOnFinishChange(this),this._onFinishChange!==void 0&&this._onFinishChange.call(this,this.getValue())),this._changed=!1}reset(){return this.setValue(this.initialValue),this._callOnFinishChange(),this}enable(t=!0){return this.disable(!t)}disable(t=!0){return t===this._disabled?this:(this._disabled=t,this.domElement.classList.toggle("lil-disabled",t),this.$disable.toggleAttribute("disabled",t),this)}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}options(t){let e=this.parent.add(this.object,this.property,t);return e.name(this._name),this.destroy(),e}min(t){return this}max(t){return this}step(t){return this}decimals(t){return this}listen(t=!0){return this._listening=t,this._listenCallbackID!==void 0&&(cancelAnimationFrame(this._listenCallbackID),this._listenCallbackID=void 0),this._listening&&this._listenCallback(),this}_listenCallback(){this._listenCallbackID=requestAnimationFrame(this._listenCallback);let t=this.save();t!==this._listenPrevValue&&this.updateDisplay(),this._listenPrevValue=t}getValue(){return this.object[this.property]}setValue(t){return this.getValue()!==t&&(this.object[this.property]=t,this._callOnChange(),this.updateDisplay()),this}updateDisplay(){return this}load(t){return this.setValue(t),this._callOnFinishChange(),this}save(){return this.getValue()}destroy(){this.listen(!1),this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.controllers.splice(this.parent.controllers.indexOf(this),1),this.parent.$children.removeChild(this.domElement)}},Bu=class extends Xn{constructor(t,e,i){super(t,e,i,"lil-boolean","label"),this.$input=document.createElement("input"),this.$input.setAttribute("type","checkbox"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$widget.appendChild(this.$input),this.$input.addEventListener("change",()=>{this.setValue(this.$input.checked),this._callOnFinishChange()}),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.checked=this.getValue(),this}};function zu(n){let t,e;return(t=n.match(/(#|0x)?([a-f0-9]{6})/i))?e=t[2]:(t=n.match(/rgb\(\s*(\d*)\s*,\s*(\d*)\s*,\s*(\d*)\s*\)/))?e=parseInt(t[1]).toString(16).padStart(2,0)+parseInt(t[2]).toString(16).padStart(2,0)+parseInt(t[3]).toString(16).padStart(2,0):(t=n.match(/^#?([a-f0-9])([a-f0-9])([a-f0-9])$/i))&&(e=t[1]+t[1]+t[2]+t[2]+t[3]+t[3]),e?"#"+e:!1}var Oy={isPrimitive:!0,match:n=>typeof n=="string",fromHexString:zu,toHexString:zu},Ko={isPrimitive:!0,match:n=>typeof n=="number",fromHexString:n=>parseInt(n.substring(1),16),toHexString:n=>"#"+n.toString(16).padStart(6,0)},ky={isPrimitive:!1,match:n=>Array.isArray(n)||ArrayBuffer.isView(n),fromHexString(n,t,e=1){let i=Ko.fromHexString(n);t[0]=(i>>16&255)/255*e,t[1]=(i>>8&255)/255*e,t[2]=(i&255)/255*e},toHexString([n,t,e],i=1){i=255/i;let s=n*i<<16^t*i<<8^e*i<<0;return Ko.toHexString(s)}},By={isPrimitive:!1,match:n=>Object(n)===n,fromHexString(n,t,e=1){let i=Ko.fromHexString(n);t.r=(i>>16&255)/255*e,t.g=(i>>8&255)/255*e,t.b=(i&255)/255*e},toHexString({r:n,g:t,b:e},i=1){i=255/i;let s=n*i<<16^t*i<<8^e*i<<0;return Ko.toHexString(s)}},zy=[Oy,Ko,ky,By];function Vy(n){return zy.find(t=>t.match(n))}var Vu=class extends Xn{constructor(t,e,i,s){super(t,e,i,"lil-color"),this.$input=document.createElement("input"),this.$input.setAttribute("type","color"),this.$input.setAttribute("tabindex",-1),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$text=document.createElement("input"),this.$text.setAttribute("type","text"),this.$text.setAttribute("spellcheck","false"),this.$text.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$display.appendChild(this.$input),this.$widget.appendChild(this.$display),this.$widget.appendChild(this.$text),this._format=Vy(this.initialValue),this._rgbScale=s,this._initialValueHexString=this.save(),this._textFocused=!1,this.$input.addEventListener("input",()=>{this._setValueFromHexString(this.$input.value)}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$text.addEventListener("input",()=>{let r=zu(this.$text.value);r&&this._setValueFromHexString(r)}),this.$text.addEventListener("focus",()=>{this._textFocused=!0,this.$text.select()}),this.$text.addEventListener("blur",()=>{this._textFocused=!1,this.updateDisplay(),this._callOnFinishChange()}),this.$disable=this.$text,this.updateDisplay()}reset(){return this._setValueFromHexString(this._initialValueHexString),this}_setValueFromHexString(t){if(this._format.isPrimitive){let e=this._format.fromHexString(t);this.setValue(e)}else this._format.fromHexString(t,this.getValue(),this._rgbScale),this._callOnChange(),this.updateDisplay()}save(){return this._format.toHexString(this.getValue(),this._rgbScale)}load(t){return this._setValueFromHexString(t),this._callOnFinishChange(),this}updateDisplay(){return this.$input.value=this._format.toHexString(this.getValue(),this._rgbScale),this._textFocused||(this.$text.value=this.$input.value.substring(1)),this.$display.style.backgroundColor=this.$input.value,this}},Zo=class extends Xn{constructor(t,e,i){super(t,e,i,"lil-function"),this.$button=document.createElement("button"),this.$button.appendChild(this.$name),this.$widget.appendChild(this.$button),this.$button.addEventListener("click",s=>{s.preventDefault(),this.getValue().call(this.object),this._callOnChange()}),this.$button.addEventListener("touchstart",()=>{},{passive:!0}),this.$disable=this.$button}},Hu=class extends Xn{constructor(t,e,i,s,r,o){super(t,e,i,"lil-number"),this._initInput(),this.min(s),this.max(r);let a=o!==void 0;this.step(a?o:this._getImplicitStep(),a),this.updateDisplay()}decimals(t){return this._decimals=t,this.updateDisplay(),this}min(t){return this._min=t,this._onUpdateMinMax(),this}max(t){return this._max=t,this._onUpdateMinMax(),this}step(t,e=!0){return this._step=t,this._stepExplicit=e,this}updateDisplay(){let t=this.getValue();if(this._hasSlider){let e=(t-this._min)/(this._max-this._min);e=Math.max(0,Math.min(e,1)),this.$fill.style.width=e*100+"%"}return this._inputFocused||(this.$input.value=this._decimals===void 0?t:t.toFixed(this._decimals)),this}_initInput(){this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("aria-labelledby",this.$name.id),window.matchMedia("(pointer: coarse)").matches&&(this.$input.setAttribute("type","number"),this.$input.setAttribute("step","any")),this.$widget.appendChild(this.$input),this.$disable=this.$input;let e=()=>{let y=parseFloat(this.$input.value);isNaN(y)||(this._stepExplicit&&(y=this._snap(y)),this.setValue(this._clamp(y)))},i=y=>{let T=parseFloat(this.$input.value);isNaN(T)||(this._snapClampSetValue(T+y),this.$input.value=this.getValue())},s=y=>{y.key==="Enter"&&this.$input.blur(),y.code==="ArrowUp"&&(y.preventDefault(),i(this._step*this._arrowKeyMultiplier(y))),y.code==="ArrowDown"&&(y.preventDefault(),i(this._step*this._arrowKeyMultiplier(y)*-1))},r=y=>{this._inputFocused&&(y.preventDefault(),i(this._step*this._normalizeMouseWheel(y)))},o=!1,a,l,c,h,d,u=5,f=y=>{a=y.clientX,l=c=y.clientY,o=!0,h=this.getValue(),d=0,window.addEventListener("mousemove",m),window.addEventListener("mouseup",v)},m=y=>{if(o){let T=y.clientX-a,M=y.clientY-l;Math.abs(M)>u?(y.preventDefault(),this.$input.blur(),o=!1,this._setDraggingStyle(!0,"vertical")):Math.abs(T)>u&&v()}if(!o){let T=y.clientY-c;d-=T*this._step*this._arrowKeyMultiplier(y),h+d>this._max?d=this._max-h:h+d<this._min&&(d=this._min-h),this._snapClampSetValue(h+d)}c=y.clientY},v=()=>{this._setDraggingStyle(!1,"vertical"),this._callOnFinishChange(),window.removeEventListener("mousemove",m),window.removeEventListener("mouseup",v)},g=()=>{this._inputFocused=!0},p=()=>{this._inputFocused=!1,this.updateDisplay(),this._callOnFinishChange()};this.$input.addEventListener("input",e),this.$input.addEventListener("keydown",s),this.$input.addEventListener("wheel",r,{passive:!1}),this.$input.addEventListener("mousedown",f),this.$input.addEventListener("focus",g),this.$input.addEventListener("blur",p)}_initSlider(){this._hasSlider=!0,this.$slider=document.createElement("div"),this.$slider.classList.add("lil-slider"),this.$fill=document.createElement("div"),this.$fill.classList.add("lil-fill"),this.$slider.appendChild(this.$fill),this.$widget.insertBefore(this.$slider,this.$input),this.domElement.classList.add("lil-has-slider");let t=(p,y,T,M,R)=>(p-y)/(T-y)*(R-M)+M,e=p=>{let y=this.$slider.getBoundingClientRect(),T=t(p,y.left,y.right,this._min,this._max);this._snapClampSetValue(T)},i=p=>{this._setDraggingStyle(!0),e(p.clientX),window.addEventListener("mousemove",s),window.addEventListener("mouseup",r)},s=p=>{e(p.clientX)},r=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("mousemove",s),window.removeEventListener("mouseup",r)},o=!1,a,l,c=p=>{p.preventDefault(),this._setDraggingStyle(!0),e(p.touches[0].clientX),o=!1},h=p=>{p.touches.length>1||(this._hasScrollBar?(a=p.touches[0].clientX,l=p.touches[0].clientY,o=!0):c(p),window.addEventListener("touchmove",d,{passive:!1}),window.addEventListener("touchend",u))},d=p=>{if(o){let y=p.touches[0].clientX-a,T=p.touches[0].clientY-l;Math.abs(y)>Math.abs(T)?c(p):(window.removeEventListener("touchmove",d),window.removeEventListener("touchend",u))}else p.preventDefault(),e(p.touches[0].clientX)},u=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("touchmove",d),window.removeEventListener("touchend",u)},f=this._callOnFinishChange.bind(this),m=400,v,g=p=>{if(Math.abs(p.deltaX)<Math.abs(p.deltaY)&&this._hasScrollBar)return;p.preventDefault();let T=this._normalizeMouseWheel(p)*this._step;this._snapClampSetValue(this.getValue()+T),this.$input.value=this.getValue(),clearTimeout(v),v=setTimeout(f,m)};this.$slider.addEventListener("mousedown",i),this.$slider.addEventListener("touchstart",h,{passive:!1}),this.$slider.addEventListener("wheel",g,{passive:!1})}_setDraggingStyle(t,e="horizontal"){this.$slider&&this.$slider.classList.toggle("lil-active",t),document.body.classList.toggle("lil-dragging",t),document.body.classList.toggle(`lil-${e}`,t)}_getImplicitStep(){return this._hasMin&&this._hasMax?(this._max-this._min)/1e3:.1}_onUpdateMinMax(){!this._hasSlider&&this._hasMin&&this._hasMax&&(this._stepExplicit||this.step(this._getImplicitStep(),!1),this._initSlider(),this.updateDisplay())}_normalizeMouseWheel(t){let{deltaX:e,deltaY:i}=t;return Math.floor(t.deltaY)!==t.deltaY&&t.wheelDelta&&(e=0,i=-t.wheelDelta/120,i*=this._stepExplicit?1:10),e+-i}_arrowKeyMultiplier(t){let e=this._stepExplicit?1:10;return t.shiftKey?e*=10:t.altKey&&(e/=10),e}_snap(t){let e=0;return this._hasMin?e=this._min:this._hasMax&&(e=this._max),t-=e,t=Math.round(t/this._step)*this._step,t+=e,t=parseFloat(t.toPrecision(15)),t}_clamp(t){return t<this._min&&(t=this._min),t>this._max&&(t=this._max),t}_snapClampSetValue(t){this.setValue(this._clamp(this._snap(t)))}get _hasScrollBar(){let t=this.parent.root.$children;return t.scrollHeight>t.clientHeight}get _hasMin(){return this._min!==void 0}get _hasMax(){return this._max!==void 0}},Gu=class extends Xn{constructor(t,e,i,s){super(t,e,i,"lil-option"),this.$select=document.createElement("select"),this.$select.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$select.addEventListener("change",()=>{this.setValue(this._values[this.$select.selectedIndex]),this._callOnFinishChange()}),this.$select.addEventListener("focus",()=>{this.$display.classList.add("lil-focus")}),this.$select.addEventListener("blur",()=>{this.$display.classList.remove("lil-focus")}),this.$widget.appendChild(this.$select),this.$widget.appendChild(this.$display),this.$disable=this.$select,this.options(s)}options(t){return this._values=Array.isArray(t)?t:Object.values(t),this._names=Array.isArray(t)?t:Object.keys(t),this.$select.replaceChildren(),this._names.forEach(e=>{let i=document.createElement("option");i.textContent=e,this.$select.appendChild(i)}),this.updateDisplay(),this}updateDisplay(){let t=this.getValue(),e=this._values.indexOf(t);return this.$select.selectedIndex=e,this.$display.textContent=e===-1?t:this._names[e],this}},Wu=class extends Xn{constructor(t,e,i){super(t,e,i,"lil-string"),this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("spellcheck","false"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$input.addEventListener("input",()=>{this.setValue(this.$input.value)}),this.$input.addEventListener("keydown",s=>{s.code==="Enter"&&this.$input.blur()}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$widget.appendChild(this.$input),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.value=this.getValue(),this}},Hy=`.lil-gui {
  font-family: var(--font-family);
  font-size: var(--font-size);
  line-height: 1;
  font-weight: normal;
  font-style: normal;
  text-align: left;
  color: var(--text-color);
  user-select: none;
  -webkit-user-select: none;
  touch-action: manipulation;
  --background-color: #1f1f1f;
  --text-color: #ebebeb;
  --title-background-color: #111111;
  --title-text-color: #ebebeb;
  --widget-color: #424242;
  --hover-color: #4f4f4f;
  --focus-color: #595959;
  --number-color: #2cc9ff;
  --string-color: #a2db3c;
  --font-size: 11px;
  --input-font-size: 11px;
  --font-family: -apple-system, BlinkMacSystemFont, "Segoe UI", Roboto, Arial, sans-serif;
  --font-family-mono: Menlo, Monaco, Consolas, "Droid Sans Mono", monospace;
  --padding: 4px;
  --spacing: 4px;
  --widget-height: 20px;
  --title-height: calc(var(--widget-height) + var(--spacing) * 1.25);
  --name-width: 45%;
  --slider-knob-width: 2px;
  --slider-input-width: 27%;
  --color-input-width: 27%;
  --slider-input-min-width: 45px;
  --color-input-min-width: 45px;
  --folder-indent: 7px;
  --widget-padding: 0 0 0 3px;
  --widget-border-radius: 2px;
  --checkbox-size: calc(0.75 * var(--widget-height));
  --scrollbar-width: 5px;
}
.lil-gui, .lil-gui * {
  box-sizing: border-box;
  margin: 0;
  padding: 0;
}
.lil-gui.lil-root {
  width: var(--width, 245px);
  display: flex;
  flex-direction: column;
  background: var(--background-color);
}
.lil-gui.lil-root > .lil-title {
  background: var(--title-background-color);
  color: var(--title-text-color);
}
.lil-gui.lil-root > .lil-children {
  overflow-x: hidden;
  overflow-y: auto;
}
.lil-gui.lil-root > .lil-children::-webkit-scrollbar {
  width: var(--scrollbar-width);
  height: var(--scrollbar-width);
  background: var(--background-color);
}
.lil-gui.lil-root > .lil-children::-webkit-scrollbar-thumb {
  border-radius: var(--scrollbar-width);
  background: var(--focus-color);
}
@media (pointer: coarse) {
  .lil-gui.lil-allow-touch-styles, .lil-gui.lil-allow-touch-styles .lil-gui {
    --widget-height: 28px;
    --padding: 6px;
    --spacing: 6px;
    --font-size: 13px;
    --input-font-size: 16px;
    --folder-indent: 10px;
    --scrollbar-width: 7px;
    --slider-input-min-width: 50px;
    --color-input-min-width: 65px;
  }
}
.lil-gui.lil-force-touch-styles, .lil-gui.lil-force-touch-styles .lil-gui {
  --widget-height: 28px;
  --padding: 6px;
  --spacing: 6px;
  --font-size: 13px;
  --input-font-size: 16px;
  --folder-indent: 10px;
  --scrollbar-width: 7px;
  --slider-input-min-width: 50px;
  --color-input-min-width: 65px;
}
.lil-gui.lil-auto-place, .lil-gui.autoPlace {
  max-height: 100%;
  position: fixed;
  top: 0;
  right: 15px;
  z-index: 1001;
}

.lil-controller {
  display: flex;
  align-items: center;
  padding: 0 var(--padding);
  margin: var(--spacing) 0;
}
.lil-controller.lil-disabled {
  opacity: 0.5;
}
.lil-controller.lil-disabled, .lil-controller.lil-disabled * {
  pointer-events: none !important;
}
.lil-controller > .lil-name {
  min-width: var(--name-width);
  flex-shrink: 0;
  white-space: pre;
  padding-right: var(--spacing);
  line-height: var(--widget-height);
}
.lil-controller .lil-widget {
  position: relative;
  display: flex;
  align-items: center;
  width: 100%;
  min-height: var(--widget-height);
}
.lil-controller.lil-string input {
  color: var(--string-color);
}
.lil-controller.lil-boolean {
  cursor: pointer;
}
.lil-controller.lil-color .lil-display {
  width: 100%;
  height: var(--widget-height);
  border-radius: var(--widget-border-radius);
  position: relative;
}
@media (hover: hover) {
  .lil-controller.lil-color .lil-display:hover:before {
    content: " ";
    display: block;
    position: absolute;
    border-radius: var(--widget-border-radius);
    border: 1px solid #fff9;
    top: 0;
    right: 0;
    bottom: 0;
    left: 0;
  }
}
.lil-controller.lil-color input[type=color] {
  opacity: 0;
  width: 100%;
  height: 100%;
  cursor: pointer;
}
.lil-controller.lil-color input[type=text] {
  margin-left: var(--spacing);
  font-family: var(--font-family-mono);
  min-width: var(--color-input-min-width);
  width: var(--color-input-width);
  flex-shrink: 0;
}
.lil-controller.lil-option select {
  opacity: 0;
  position: absolute;
  width: 100%;
  max-width: 100%;
}
.lil-controller.lil-option .lil-display {
  position: relative;
  pointer-events: none;
  border-radius: var(--widget-border-radius);
  height: var(--widget-height);
  line-height: var(--widget-height);
  max-width: 100%;
  overflow: hidden;
  word-break: break-all;
  padding-left: 0.55em;
  padding-right: 1.75em;
  background: var(--widget-color);
}
@media (hover: hover) {
  .lil-controller.lil-option .lil-display.lil-focus {
    background: var(--focus-color);
  }
}
.lil-controller.lil-option .lil-display.lil-active {
  background: var(--focus-color);
}
.lil-controller.lil-option .lil-display:after {
  font-family: "lil-gui";
  content: "↕";
  position: absolute;
  top: 0;
  right: 0;
  bottom: 0;
  padding-right: 0.375em;
}
.lil-controller.lil-option .lil-widget,
.lil-controller.lil-option select {
  cursor: pointer;
}
@media (hover: hover) {
  .lil-controller.lil-option .lil-widget:hover .lil-display {
    background: var(--hover-color);
  }
}
.lil-controller.lil-number input {
  color: var(--number-color);
}
.lil-controller.lil-number.lil-has-slider input {
  margin-left: var(--spacing);
  width: var(--slider-input-width);
  min-width: var(--slider-input-min-width);
  flex-shrink: 0;
}
.lil-controller.lil-number .lil-slider {
  width: 100%;
  height: var(--widget-height);
  background: var(--widget-color);
  border-radius: var(--widget-border-radius);
  padding-right: var(--slider-knob-width);
  overflow: hidden;
  cursor: ew-resize;
  touch-action: pan-y;
}
@media (hover: hover) {
  .lil-controller.lil-number .lil-slider:hover {
    background: var(--hover-color);
  }
}
.lil-controller.lil-number .lil-slider.lil-active {
  background: var(--focus-color);
}
.lil-controller.lil-number .lil-slider.lil-active .lil-fill {
  opacity: 0.95;
}
.lil-controller.lil-number .lil-fill {
  height: 100%;
  border-right: var(--slider-knob-width) solid var(--number-color);
  box-sizing: content-box;
}

.lil-dragging .lil-gui {
  --hover-color: var(--widget-color);
}
.lil-dragging * {
  cursor: ew-resize !important;
}
.lil-dragging.lil-vertical * {
  cursor: ns-resize !important;
}

.lil-gui .lil-title {
  height: var(--title-height);
  font-weight: 600;
  padding: 0 var(--padding);
  width: 100%;
  text-align: left;
  background: none;
  text-decoration-skip: objects;
}
.lil-gui .lil-title:before {
  font-family: "lil-gui";
  content: "▾";
  padding-right: 2px;
  display: inline-block;
}
.lil-gui .lil-title:active {
  background: var(--title-background-color);
  opacity: 0.75;
}
@media (hover: hover) {
  body:not(.lil-dragging) .lil-gui .lil-title:hover {
    background: var(--title-background-color);
    opacity: 0.85;
  }
  .lil-gui .lil-title:focus {
    text-decoration: underline var(--focus-color);
  }
}
.lil-gui.lil-root > .lil-title:focus {
  text-decoration: none !important;
}
.lil-gui.lil-closed > .lil-title:before {
  content: "▸";
}
.lil-gui.lil-closed > .lil-children {
  transform: translateY(-7px);
  opacity: 0;
}
.lil-gui.lil-closed:not(.lil-transition) > .lil-children {
  display: none;
}
.lil-gui.lil-transition > .lil-children {
  transition-duration: 300ms;
  transition-property: height, opacity, transform;
  transition-timing-function: cubic-bezier(0.2, 0.6, 0.35, 1);
  overflow: hidden;
  pointer-events: none;
}
.lil-gui .lil-children:empty:before {
  content: "Empty";
  padding: 0 var(--padding);
  margin: var(--spacing) 0;
  display: block;
  height: var(--widget-height);
  font-style: italic;
  line-height: var(--widget-height);
  opacity: 0.5;
}
.lil-gui.lil-root > .lil-children > .lil-gui > .lil-title {
  border: 0 solid var(--widget-color);
  border-width: 1px 0;
  transition: border-color 300ms;
}
.lil-gui.lil-root > .lil-children > .lil-gui.lil-closed > .lil-title {
  border-bottom-color: transparent;
}
.lil-gui + .lil-controller {
  border-top: 1px solid var(--widget-color);
  margin-top: 0;
  padding-top: var(--spacing);
}
.lil-gui .lil-gui .lil-gui > .lil-title {
  border: none;
}
.lil-gui .lil-gui .lil-gui > .lil-children {
  border: none;
  margin-left: var(--folder-indent);
  border-left: 2px solid var(--widget-color);
}
.lil-gui .lil-gui .lil-controller {
  border: none;
}

.lil-gui label, .lil-gui input, .lil-gui button {
  -webkit-tap-highlight-color: transparent;
}
.lil-gui input {
  border: 0;
  outline: none;
  font-family: var(--font-family);
  font-size: var(--input-font-size);
  border-radius: var(--widget-border-radius);
  height: var(--widget-height);
  background: var(--widget-color);
  color: var(--text-color);
  width: 100%;
}
@media (hover: hover) {
  .lil-gui input:hover {
    background: var(--hover-color);
  }
  .lil-gui input:active {
    background: var(--focus-color);
  }
}
.lil-gui input:disabled {
  opacity: 1;
}
.lil-gui input[type=text],
.lil-gui input[type=number] {
  padding: var(--widget-padding);
  -moz-appearance: textfield;
}
.lil-gui input[type=text]:focus,
.lil-gui input[type=number]:focus {
  background: var(--focus-color);
}
.lil-gui input[type=checkbox] {
  appearance: none;
  width: var(--checkbox-size);
  height: var(--checkbox-size);
  border-radius: var(--widget-border-radius);
  text-align: center;
  cursor: pointer;
}
.lil-gui input[type=checkbox]:checked:before {
  font-family: "lil-gui";
  content: "✓";
  font-size: var(--checkbox-size);
  line-height: var(--checkbox-size);
}
@media (hover: hover) {
  .lil-gui input[type=checkbox]:focus {
    box-shadow: inset 0 0 0 1px var(--focus-color);
  }
}
.lil-gui button {
  outline: none;
  cursor: pointer;
  font-family: var(--font-family);
  font-size: var(--font-size);
  color: var(--text-color);
  width: 100%;
  border: none;
}
.lil-gui .lil-controller button {
  height: var(--widget-height);
  text-transform: none;
  background: var(--widget-color);
  border-radius: var(--widget-border-radius);
}
@media (hover: hover) {
  .lil-gui .lil-controller button:hover {
    background: var(--hover-color);
  }
  .lil-gui .lil-controller button:focus {
    box-shadow: inset 0 0 0 1px var(--focus-color);
  }
}
.lil-gui .lil-controller button:active {
  background: var(--focus-color);
}

@font-face {
  font-family: "lil-gui";
  src: url("data:application/font-woff2;charset=utf-8;base64,d09GMgABAAAAAALkAAsAAAAABtQAAAKVAAEAAAAAAAAAAAAAAAAAAAAAAAAAAAAAHFQGYACDMgqBBIEbATYCJAMUCwwABCAFhAoHgQQbHAbIDiUFEYVARAAAYQTVWNmz9MxhEgodq49wYRUFKE8GWNiUBxI2LBRaVnc51U83Gmhs0Q7JXWMiz5eteLwrKwuxHO8VFxUX9UpZBs6pa5ABRwHA+t3UxUnH20EvVknRerzQgX6xC/GH6ZUvTcAjAv122dF28OTqCXrPuyaDER30YBA1xnkVutDDo4oCi71Ca7rrV9xS8dZHbPHefsuwIyCpmT7j+MnjAH5X3984UZoFFuJ0yiZ4XEJFxjagEBeqs+e1iyK8Xf/nOuwF+vVK0ur765+vf7txotUi0m3N0m/84RGSrBCNrh8Ee5GjODjF4gnWP+dJrH/Lk9k4oT6d+gr6g/wssA2j64JJGP6cmx554vUZnpZfn6ZfX2bMwPPrlANsB86/DiHjhl0OP+c87+gaJo/gY084s3HoYL/ZkWHTRfBXvvoHnnkHvngKun4KBE/ede7tvq3/vQOxDXB1/fdNz6XbPdcr0Vhpojj9dG+owuSKFsslCi1tgEjirjXdwMiov2EioadxmqTHUCIwo8NgQaeIasAi0fTYSPTbSmwbMOFduyh9wvBrESGY0MtgRjtgQR8Q1bRPohn2UoCRZf9wyYANMXFeJTysqAe0I4mrherOekFdKMrYvJjLvOIUM9SuwYB5DVZUwwVjJJOaUnZCmcEkIZZrKqNvRGRMvmFZsmhP4VMKCSXBhSqUBxgMS7h0cZvEd71AWkEhGWaeMFcNnpqyJkyXgYL7PQ1MoSq0wDAkRtJIijkZSmqYTiSImfLiSWXIZwhRh3Rug2X0kk1Dgj+Iu43u5p98ghopcpSo0Uyc8SnjlYX59WUeaMoDqmVD2TOWD9a4pCRAzf2ECgwGcrHjPOWY9bNxq/OL3I/QjwEAAAA=") format("woff2");
}`;function Gy(n){let t=document.createElement("style");t.innerHTML=n;let e=document.querySelector("head link[rel=stylesheet], head style");e?document.head.insertBefore(t,e):document.head.appendChild(t)}var Um=!1,Rl=class n{constructor({parent:t,autoPlace:e=t===void 0,container:i,width:s,title:r="Controls",closeFolders:o=!1,injectStyles:a=!0,touchStyles:l=!0}={}){if(this.parent=t,this.root=t?t.root:this,this.children=[],this.controllers=[],this.folders=[],this._closed=!1,this._hidden=!1,this.domElement=document.createElement("div"),this.domElement.classList.add("lil-gui"),this.$title=document.createElement("button"),this.$title.classList.add("lil-title"),this.$title.setAttribute("aria-expanded",!0),this.$title.addEventListener("click",()=>this.openAnimated(this._closed)),this.$title.addEventListener("touchstart",()=>{},{passive:!0}),this.$children=document.createElement("div"),this.$children.classList.add("lil-children"),this.domElement.appendChild(this.$title),this.domElement.appendChild(this.$children),this.title(r),this.parent){this.parent.children.push(this),this.parent.folders.push(this),this.parent.$children.appendChild(this.domElement);return}this.domElement.classList.add("lil-root"),l&&this.domElement.classList.add("lil-allow-touch-styles"),!Um&&a&&(Gy(Hy),Um=!0),i?i.appendChild(this.domElement):e&&(this.domElement.classList.add("lil-auto-place","autoPlace"),document.body.appendChild(this.domElement)),s&&this.domElement.style.setProperty("--width",s+"px"),this._closeFolders=o}add(t,e,i,s,r){if(Object(i)===i)return new Gu(this,t,e,i);let o=t[e];switch(typeof o){case"number":return new Hu(this,t,e,i,s,r);case"boolean":return new Bu(this,t,e);case"string":return new Wu(this,t,e);case"function":return new Zo(this,t,e)}console.error(`gui.add failed
	property:`,e,`
	object:`,t,`
	value:`,o)}addColor(t,e,i=1){return new Vu(this,t,e,i)}addFolder(t){let e=new n({parent:this,title:t});return this.root._closeFolders&&e.close(),e}load(t,e=!0){return t.controllers&&this.controllers.forEach(i=>{i instanceof Zo||i._name in t.controllers&&i.load(t.controllers[i._name])}),e&&t.folders&&this.folders.forEach(i=>{i._title in t.folders&&i.load(t.folders[i._title])}),this}save(t=!0){let e={controllers:{},folders:{}};return this.controllers.forEach(i=>{if(!(i instanceof Zo)){if(i._name in e.controllers)throw new Error(`Cannot save GUI with duplicate property "${i._name}"`);e.controllers[i._name]=i.save()}}),t&&this.folders.forEach(i=>{if(i._title in e.folders)throw new Error(`Cannot save GUI with duplicate folder "${i._title}"`);e.folders[i._title]=i.save()}),e}open(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),this.domElement.classList.toggle("lil-closed",this._closed),this}close(){return this.open(!1)}_setClosed(t){this._closed!==t&&(this._closed=t,this._callOnOpenClose(this))}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}openAnimated(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),requestAnimationFrame(()=>{let e=this.$children.clientHeight;this.$children.style.height=e+"px",this.domElement.classList.add("lil-transition");let i=r=>{r.target===this.$children&&(this.$children.style.height="",this.domElement.classList.remove("lil-transition"),this.$children.removeEventListener("transitionend",i))};this.$children.addEventListener("transitionend",i);let s=t?this.$children.scrollHeight:0;this.domElement.classList.toggle("lil-closed",!t),requestAnimationFrame(()=>{this.$children.style.height=s+"px"})}),this}title(t){return this._title=t,this.$title.textContent=t,this}reset(t=!0){return(t?this.controllersRecursive():this.controllers).forEach(i=>i.reset()),this}onChange(t){return this._onChange=t,this}_callOnChange(t){this.parent&&this.parent._callOnChange(t),this._onChange!==void 0&&this._onChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(t){this.parent&&this.parent._callOnFinishChange(t),this._onFinishChange!==void 0&&this._onFinishChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onOpenClose(t){return this._onOpenClose=t,this}_callOnOpenClose(t){this.parent&&this.parent._callOnOpenClose(t),this._onOpenClose!==void 0&&this._onOpenClose.call(this,t)}destroy(){this.parent&&(this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.folders.splice(this.parent.folders.indexOf(this),1)),this.domElement.parentElement&&this.domElement.parentElement.removeChild(this.domElement),Array.from(this.children).forEach(t=>t.destroy())}controllersRecursive(){let t=Array.from(this.controllers);return this.folders.forEach(e=>{t=t.concat(e.controllersRecursive())}),t}foldersRecursive(){let t=Array.from(this.folders);return this.folders.forEach(e=>{t=t.concat(e.foldersRecursive())}),t}};var Xu=1e3,Wy=9,Om=Xn,Cl=class extends Om{constructor(t,e,i){super(t,e,"value","quantity"),this.parameter=i,this.sliding=!1,this.slider=W("input",{type:"range",min:"0",max:String(Xu),step:"1","aria-label":i.label,oninput:()=>{this.sliding=!0,this.setValue(Pm(this.scale,Number(this.slider.value)/Xu))},onchange:()=>{this.sliding=!1,this._callOnFinishChange()}}),this.field=W("input",{type:"text",inputMode:"decimal",spellcheck:!1,autocomplete:"off","aria-label":`${i.label} [${i.unit}]`,onchange:()=>this.commit(),onkeydown:s=>{s.key==="Enter"&&this.commit()}}),this.$widget.append(this.slider,this.field),this.updateDisplay()}get scale(){let{low:t,high:e,scale:i,kind:s}=this.parameter;return{low:t,high:e,scale:i,whole:s==="whole"}}commit(){let t=this.getValue(),i=t!==null&&this.field.value===Yr(t)?t:er(this.field.value);Number.isFinite(i)&&i!==t?this.setValue(i):this.updateDisplay()}updateDisplay(){let t=this.getValue();this.sliding||(this.slider.value=String(t===null?0:Xu*Im(this.scale,t)));let e=t===null?"":Yr(t);(document.activeElement!==this.field||this.sliding)&&(this.field.value=e,this.field.placeholder=t===null?"differ":"");let i=t===null?"":String(t);return this.field.toggleAttribute("title",e!==i),e!==i&&(this.field.title=i),this}disable(t=!0){return this.slider.disabled=this.field.disabled=t,super.disable(t)}},Pl=class extends Om{constructor(t,e,i){super(t,e,"value","vector"),this.fields=["x","y","z"].map(s=>W("input",{type:"text",inputMode:"decimal",spellcheck:!1,autocomplete:"off","aria-label":`${i.label} ${s} [${i.unit}]`,onchange:()=>this.commit()})),this.$widget.append(...this.fields),this.updateDisplay()}commit(){let t=this.getValue()??[],e=this.fields.map(({value:i},s)=>i===this.text(t[s])?t[s]:er(i));e.every(Number.isFinite)?this.setValue(e):this.updateDisplay()}updateDisplay(){let t=this.getValue()??["","",""];return this.fields.forEach((e,i)=>{document.activeElement!==e&&(e.value=this.text(t[i]),e.title=`${"xyz"[i]}: ${t[i]}`)}),this}text(t){return typeof t=="number"?Yr(t,Wy):""}disable(t=!0){for(let e of this.fields)e.disabled=t;return super.disable(t)}};var Il=class{constructor(t,e){this.session=t,this.host=e,this.gui=null,this.rows=new Map,this.queue=new Map,this.asked=new Set,this.rope="",this.built="",this.closed=new Map,t.on("parameters",i=>this.build(i))}build(t){let e=JSON.stringify(t.map(i=>[i.name,i.kind,i.unit,i.choices,i.group,i.more,i.label,Object.keys(i.values??{})]));e===this.built&&this.gui?this.refresh(t):this.rebuild(t,e)}rebuild(t,e){let i=this.host.scrollTop;this.built=e,this.gui?.destroy(),this.rows.clear(),this.gui=new Rl({container:this.host,injectStyles:!1,title:"Change it while it runs"});let s=[...new Set(t.flatMap(o=>Object.keys(o.values??{})))];s.includes(this.rope)||(this.rope=""),s.length>1&&this.addRopeChoice(this.gui,s);for(let o of t)o.more||this.addRow(this.gui,o);let r=t.filter(({more:o})=>o);if(r.length){let o=this.addFolder(this.gui,"More",!0);for(let a of[...new Set(r.map(l=>l.group))]){let l=this.addFolder(o,a,a==="Air"||a==="Ground");for(let c of r)c.group===a&&this.addRow(l,c)}}this.host.scrollTop=i}addFolder(t,e,i){let s=t.addFolder(e);return s.onOpenClose(r=>{r===s&&this.closed.set(e,s._closed)}),(this.closed.get(e)??i)&&s.close(),s}addRopeChoice(t,e){let i=Object.fromEntries([["all ropes",""],...e.map(s=>[s,s])]);t.add(this,"rope",i).name("Change").onChange(()=>this.refresh(this.session.parameters))}addRow(t,e){let i={value:this.valueOf(e)},s;if(e.kind==="choice"){let c=(e.choices??[]).map(({value:h,label:d})=>[d,h]);s=t.add(i,"value",Object.fromEntries(c))}else e.kind==="flag"?s=t.add(i,"value"):e.kind==="vector"?s=new Pl(t,i,e):s=new Cl(t,i,e);let r=Nr(e.unit),o=W("button",{type:"button",className:"back",onclick:()=>this.set(e.name,null)},mn("undo")),a=W("div",{className:"fault",hidden:!0,role:"alert"});s.name(""),s.$name.append(W("span",{},e.label),r&&W("em",{},r),o),s.domElement.append(a),s.domElement.dataset.parameter=e.name,s.onChange(c=>this.set(e.name,c));let l={parameter:e,holder:i,controller:s,back:o,fault:a};this.rows.set(e.name,l),this.show(l)}valueOf(t){return this.rope&&t.values&&this.rope in t.values?t.values[this.rope]:t.value}show(t){let{parameter:e,controller:i,holder:s,back:r}=t;t.controller.parameter=e,s.value=this.valueOf(e),i.updateDisplay(),i.disable(!e.enabled);let o=$u(e.default),a=$u(s.value)!==o;r.classList.toggle("unused",!a),r.disabled=!a||!e.enabled,r.title=`Back to ${o||"the scene's"} ${Nr(e.unit)}`.trim(),r.setAttribute("aria-label",`${e.label}: back to the scene's value`),i.domElement.title=e.enabled?e.help:e.why||e.help}refresh(t){for(let e of t){let i=this.rows.get(e.name);i&&(i.parameter=e,this.busy(e.name)||this.show(i))}}busy(t){return this.queue.has(t)||this.asked.has(t)||this.rows.get(t)?.controller.sliding}set(t,e){this.queue.size||requestAnimationFrame(()=>this.flush()),this.queue.set(t,e)}flush(){for(let[t,e]of this.queue)this.asked.has(t)||(this.queue.delete(t),this.send(t,e))}async send(t,e){let i=this.rows.get(t);this.asked.add(t);try{let o=this.rope&&i?.parameter.values?this.rope:null;await this.session.ask({type:"set",name:t,value:e,rope:o}),this.fault(t,"")}catch(o){this.fault(t,o.text)}if(this.asked.delete(t),this.queue.has(t)){this.flush();return}let s=this.rows.get(t),r=this.session.parameters.find(o=>o.name===t);s&&r&&!s.controller.sliding&&(s.parameter=r,this.show(s))}fault(t,e){let i=this.rows.get(t);i&&(i.fault.hidden=e==="",i.fault.textContent=e)}};function $u(n){return n==null?"":typeof n=="number"?String(Number(n.toPrecision(6))):Array.isArray(n)?`[${n.map($u).join(", ")}]`:String(n)}var Ll=class{constructor(t,e){this.stage=t;let i=(s,r)=>W("button",{type:"button",className:"plain letter",id:`view-${s.toLowerCase()}`,title:`Look along the ${s.toLowerCase()} axis; again: from the other side`,"aria-label":`Look along the ${s.toLowerCase()} axis`,onclick:()=>this.along(r)},s);e.append(W("div",{className:"toolbar views",role:"toolbar","aria-label":"View"},Di("fit","Show everything",()=>t.fit(),{key:"F",id:"view-fit"}),i("X",0),i("Y",1),i("Z",2),W("button",{type:"button",className:"plain letter",id:"view-home",title:"The first view","aria-label":"The first view",onclick:()=>this.home()},"3D")))}along(t){let{camera:e}=this.stage,i=t===1&&Math.abs(e.up[1])<.9?-1:1,s=e.along(t,i),r=Math.abs(e.toward[t]-i)<.001;this.stage.fit(r?e.along(t,i===1?-1:1):s)}home(){let{layout:t}=this.stage.session;t&&this.stage.fly(this.stage.firstPose(t))}};var ir=class{constructor(t){this.shown=new Float32Array(t),this.from=new Float32Array(t),this.to=new Float32Array(t),this.arrival=0,this.spacing=1e3/60,this.part=1,this.empty=!0}next(t,e=!1){let i=t-this.arrival;return this.arrival=t,this.empty||e?(this.empty=!1,this.part=1-1e-9,this.arrival=-1/0,this.to):(i<250&&(this.spacing+=.15*(Math.max(4,i)-this.spacing)),this.from.set(this.shown),this.part=0,this.to)}advance(t){if(this.empty||this.part>=1)return!1;this.part=Math.min(1,Math.max(this.part,(t-this.arrival)/this.spacing));let{shown:e,from:i,to:s,part:r}=this;if(r>=1)e.set(s);else for(let o=0;o<e.length;o++)e[o]=i[o]+r*(s[o]-i[o]);return!0}};var qu=28*Math.PI/180,Xy=.72,$y=.35,qy=.68,Nl=Math.PI/2,Dl=class n{constructor(){this.width=1,this.height=1,this.pose={target:[0,0,0],distance:5,azimuth:-Nl+.5,elevation:.22},this.view=new Float32Array(16),this.projection=new Float32Array(16),this.version=0,this.up=[0,0,1],this.first=[1,0,0],this.second=[0,1,0],this.light=[0,0,1],this.eye=[0,0,0],this.right=[1,0,0],this.top=[0,0,1],this.toward=[0,-1,0],this.update()}setUp(t){this.up=Ha(t);let e=Math.abs(this.up[0])<.9?[1,0,0]:[0,0,1];this.first=Ha(os(e,ui(this.up,$e(e,this.up)))),this.second=Do(this.up,this.first);let i=ce(ui(this.first,-.45),this.second,-.55);this.light=Ha(ce(i,this.up)),this.update()}resize(t,e){this.width=Math.max(1,t),this.height=Math.max(1,e),this.update()}set(t){let e={...this.pose,...t},{target:i,distance:s,azimuth:r,elevation:o}=e;[...i,s,r,o].every(Number.isFinite)&&(this.pose=e,this.pose.elevation=Math.min(Nl,Math.max(-Nl,this.pose.elevation)),this.pose.distance=Math.min(1e7,Math.max(1e-4,this.pose.distance)),this.update())}update(){let{target:t,distance:e,azimuth:i,elevation:s}=this.pose,[r,o]=[Math.cos(i),Math.sin(i)],[a,l]=[Math.cos(s),Math.sin(s)],c=ce(ui(this.first,r),this.second,o);this.toward=ce(ui(c,a),this.up,l),this.right=ce(ui(this.first,-o),this.second,r),this.top=Do(this.toward,this.right),this.eye=ce(t,this.toward,e);let h=[this.right,this.top,this.toward];for(let m=0;m<3;m++){for(let v=0;v<3;v++)this.view[4*v+m]=h[m][v];this.view[12+m]=-$e(h[m],this.eye),this.view[4*m+3]=0}this.view[15]=1;let d=e*.01,u=e*200,f=1/Math.tan(qu/2);this.projection.fill(0),this.projection[0]=f*this.height/this.width,this.projection[5]=f,this.projection[10]=(u+d)/(d-u),this.projection[11]=-1,this.projection[14]=2*u*d/(d-u),this.version++}get focal(){return this.height/2/Math.tan(qu/2)}project(t,e,i){let s=this.view,r=-(s[2]*t+s[6]*e+s[10]*i+s[14]),o=this.focal/Math.max(r,1e-9);return[this.width/2+(s[0]*t+s[4]*e+s[8]*i+s[12])*o,this.height/2-(s[1]*t+s[5]*e+s[9]*i+s[13])*o,r]}eyeHeight(t){return $e(this.eye,this.up)-t}ray(t,e){let i=(t-this.width/2)/this.focal,s=(this.height/2-e)/this.focal;return ce(ce(ui(this.toward,-1),this.right,i),this.top,s)}inPlane(t,e,i){let s=$e(os(this.eye,i),this.toward);return ce(this.eye,this.ray(t,e),s)}onPlane(t,e,i,s){let r=this.ray(t,e);return s<0||Math.abs(r[s])<$y?this.inPlane(t,e,i):ce(this.eye,r,(i[s]-this.eye[s])/r[s])}orbit(t,e){let i=1.2*Math.PI/Math.min(this.width,this.height);this.set({azimuth:this.pose.azimuth-t*i,elevation:this.pose.elevation+e*i})}pan(t,e){let i=this.pose.distance/this.focal,s=ce(ce(this.pose.target,this.right,-t*i),this.top,e*i);this.set({target:s})}zoom(t,e=this.width/2,i=this.height/2){let s=this.inPlane(e,i,this.pose.target);this.set({distance:this.pose.distance*t});let r=this.inPlane(e,i,this.pose.target);this.set({target:ce(this.pose.target,os(s,r))})}at(t){let e=new n;return e.setUp(this.up),e.resize(this.width,this.height),e.set({...this.pose,...t}),e}fitted(t,e={},i){let s=Array.from({length:8},(r,o)=>Ni([0,1,2].map(a=>o>>a&1?t.high[a]:t.low[a])));return this.framed(s,e,i)}framed(t,e={},{top:i,bottom:s}={top:0,bottom:0}){let r=this.at({...e,target:[0,0,0],distance:1}),o=Math.tan(qu/2),a=Math.max(.3,1-(i+s)/this.height),l=o*qy*a,c=o*Xy*this.width/this.height,[h,d,u,f]=[-1/0,-1/0,-1/0,-1/0],[m,v]=[-1/0,1/0];for(let R of t){let[A,_,E]=[r.right,r.top,r.toward].map(k=>$e(R,k));h=Math.max(h,A+c*E),d=Math.max(d,c*E-A),u=Math.max(u,_+l*E),f=Math.max(f,l*E-_),m=Math.max(m,E),v=Math.min(v,E)}let g=Math.max((h+d)/(2*c),(u+f)/(2*l),m+.001),p=(m+v)/2,y=g-p,T=(i-s)/2*(y/this.focal),M=ce(ce(ui(r.right,(h-d)/2),r.top,(u-f)/2+T),r.toward,p);return{...r.pose,target:M,distance:y}}along(t,e=1){let i=[0,0,0];return i[t]=e,this.angles(i)}angles(t){let e=$e(t,this.up),i=$e(t,this.first),s=$e(t,this.second);return{azimuth:Math.hypot(i,s)>1e-6?Math.atan2(s,i):-Nl,elevation:Math.atan2(e,Math.hypot(i,s))}}};var Yy=320,km=1600,Fl=class{constructor(t,e,i,s=Yy){this.duration=s;let r=e.azimuth-t.azimuth;this.from=t,this.to=e,this.turn=r-2*Math.PI*Math.round(r/(2*Math.PI)),this.start=i}at(t){let e=Math.min(1,Math.max(0,(t-this.start)/this.duration)),i=e*e*(3-2*e),{from:s,to:r}=this;return{over:e>=1,pose:{target:ce(s.target,os(r.target,s.target),i),distance:s.distance*(r.distance/s.distance)**i,azimuth:s.azimuth+i*this.turn,elevation:s.elevation+i*(r.elevation-s.elevation)}}}};var Zy=4,Ky=4,Jy=300,Bm=.95,jy=.75,Ul=class{constructor(){this.low=[1/0,1/0,1/0],this.high=[-1/0,-1/0,-1/0],this.angles=""}clear(){this.low.fill(1/0),this.high.fill(-1/0)}take(t,e,i,s,{center:r,radius:o}){let a=`${t.pose.azimuth} ${t.pose.elevation}`;a!==this.angles&&this.clear(),this.angles=a;let l=[t.right,t.top,t.toward],c=Math.max(1,Math.ceil(i/Jy)),h=1-Math.exp(-s/Zy);l.forEach(([d,u,f],m)=>{let v=r[0]*d+r[1]*u+r[2]*f,[g,p]=[1/0,-1/0];for(let y=0;y<i;y+=c){let T=e[4*y]*d+e[4*y+1]*u+e[4*y+2]*f;Math.abs(T-v)>Ky*o||(T<g&&(g=T),T>p&&(p=T))}Number.isFinite(g+p)&&(this.low[m]=g<this.low[m]?g:this.low[m]+h*(g-this.low[m]),this.high[m]=p>this.high[m]?p:this.high[m]+h*(p-this.high[m]))})}wanted(t,e){if(!this.low.every(Number.isFinite))return null;let i=t.framed(this.corners(t),{},e);return i.distance<jy*t.pose.distance||this.leaves(t,e)?i:null}leaves(t,{top:e,bottom:i}){let{width:s,height:r}=t;return this.corners(t).some(o=>{let[a,l,c]=t.project(...o),h=Math.abs(a-s/2)/(s/2),d=(e+r-i)/2,u=Math.abs(l-d)/((r-e-i)/2);return c<=0||h>Bm||u>Bm})}corners({right:t,top:e,toward:i}){let{low:s,high:r}=this;return Array.from({length:8},(o,a)=>{let[l,c,h]=[0,1,2].map(d=>a>>d&1?r[d]:s[d]);return[0,1,2].map(d=>l*t[d]+c*e[d]+h*i[d])})}};function zm(n,t,e,i){let s=t.first+t.nodes-1,r=n.map(({index:l})=>l).filter(l=>l>=t.first&&l<=s).sort((l,c)=>l-c),o=t.length/Math.max(1,t.segments),a=1/0;return r.forEach((l,c)=>{let h=e(l),d=$e(h,i),u=r[c+1];if(c===0&&(a=Math.min(a,d-(l-t.first)*o)),u===void 0){a=Math.min(a,d-(s-l)*o);return}let f=e(u),m=(u-l)*o,v=d-$e(f,i),g=Math.max(0,h.reduce((y,T,M)=>y+(T-f[M])**2,0)-v*v),p=Math.sqrt(Math.max(0,m*m-g));a=Math.min(a,d,d-(v+p)/2)}),a}var Qy=.28,tM=1e4,eM=3e38;function Vm(n,t,{center:e,radius:i}){let[s,r,o]=e,a=tM*i,l=h=>!(Math.abs(n[h]-s)<a&&Math.abs(n[h+1]-r)<a&&Math.abs(n[h+2]-o)<a),c=null;for(let h=0,d=0;h<t;h++,d+=4){if(!l(d)){Number.isFinite(n[d+3])||(n[d+3]=0);continue}if(h>0)c=n.subarray(d-4,d-1);else{let u=0;for(;u<t&&l(4*u);)u++;c=u<t?n.slice(4*u,4*u+3):e}n.set(c,d),n[d+3]=eM}}function Hm(n,t){let e={low:[1/0,1/0,1/0],high:[-1/0,-1/0,-1/0]};for(let i=0;i<t;i++)for(let s=0;s<3;s++){let r=n[4*i+s];r<e.low[s]&&(e.low[s]=r),r>e.high[s]&&(e.high[s]=r)}return e}function Gm(n,t,e){let i=[0,1,2].filter(r=>n.high[r]-n.low[r]<1e-4*e);if(!i.length)return-1;let s=i.filter(r=>Math.abs(t[r])<.9);return s.length>1?s.includes(1)?1:s[s.length-1]:s.length?s[0]:i[0]}function Wm(n,t){if(t<0)return{azimuth:-Math.PI/2+.55,elevation:.3};if(Math.abs(n.up[t])>.9)return{azimuth:-Math.PI/2,elevation:Math.PI/2};let e=Ni([0,0,0]);e[t]=1;let i=$e(Do(n.up,e),[1,1,1])>=0?1:-1,{azimuth:s}=n.along(t,i);return{azimuth:s-Qy,elevation:.14}}function Xm(n,t,e){let i=t.ground?t.ground.height:e,s=Xf(n.pose.distance*.28/5),{target:r}=n.pose,o=Math.round($e(r,n.first)/s)*s,a=Math.round($e(r,n.second)/s)*s,l=ce(ce(ui(n.first,o),n.second,a),n.up,i);return{height:i,solid:t.ground!==null,spacing:s,radius:14*s,center:l}}var iM=["background","horizon","grid","shadow","ground","anchor","hand","load","arrow","grab","pin","hover","node","post"],$m="ropewalk-theme";function qm(){let n=new URLSearchParams(location.search).get("theme")??nM();return n==="light"||n==="dark"?n:matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"}function nM(){try{return localStorage.getItem($m)}catch{return null}}function Ol(n,t=!1){if(document.documentElement.dataset.theme=n,!!t)try{localStorage.setItem($m,n)}catch{}}function Yu(){let n=document.documentElement.dataset.theme==="dark",t=getComputedStyle(document.documentElement);return{...Object.fromEntries(iM.map(i=>[i,Ys(t.getPropertyValue(`--scene-${i}`).trim()||"#888888")])),rim:qf(n),dark:n}}function nr(n){let t=Math.max(1,Math.min(1024,n));return[t,Math.max(1,Math.ceil(n/t))]}function Ym(n,t,e,i,s){let r=0,[o,a]=[1/0,-1/0];return t.variants.forEach((l,c)=>{let h=n.parts[c],[d,u,f]=i[c],{positions:m}=h;for(let v=0,g=0,p=r;v<l.nodes;v++,g+=3,p+=4)s[p]=m[g]+d,s[p+1]=m[g+1]+u,s[p+2]=m[g+2]+f;if(e==="speed"){let v=Yi(t,h,"speed_high");for(let g=0;g<l.nodes;g++)s[r+4*g+3]=h.speed[g]/65535*v;o=0,a=Math.max(a,v)}else if(e!=="plain"){let v=Yi(t,h,"tension_low"),g=(Yi(t,h,"tension_high")-v)/65535;for(let p of l.ropes){let y=e==="strain"?1/p.EA:1,T=p.first+p.nodes-1,M=h.tension[p.first];for(let R=p.first;R<=T;R++){let A=R<T?h.tension[R]:M,_=(v+g*.5*(M+A))*y;M=A,s[r+4*R+3]=_,_<o&&(o=_),_>a&&(a=_)}}}r+=4*l.nodes}),{low:o,high:a}}var sM=.12,rM=.1,oM=4,kl=class{constructor(t){this.stage=t,this.height=0,this.goal=0}get level(){return this.stage.session.layout?.ground?.height??this.height}put(t,e){let{camera:i,nodes:s,starts:r}=this.stage,{up:o}=i,a=u=>Ni(s.to.subarray(4*u,4*u+3)),l=t.variants.flatMap(({ropes:u,anchors:f},m)=>u.map(v=>zm(f,v,g=>a(r[m]+g),o))),c=Math.hypot(...e.high.map((u,f)=>u-e.low[f])),h=Math.min(...[e.low,e.high].map(u=>$e(u,o))),d=Math.min(...l,h)-sM*c;Number.isFinite(d)&&(this.height=this.goal=d)}giveWay(t){if(t.ground)return;let{up:e}=this.stage.camera,{to:i}=this.stage.nodes,{center:s,radius:r}=t.view,o=1/0;for(let a=0;a<4*Ki(t);a+=4)o=Math.min(o,i[a]*e[0]+i[a+1]*e[1]+i[a+2]*e[2]);o>=this.height||o<$e(s,e)-oM*r||(this.goal=Math.min(this.goal,o-rM*r))}advance(){let t=this.goal-this.height,{layout:e}=this.stage.session;t===0||!e||(this.height+=Math.abs(t)<.003*e.view.radius?t:.08*t,this.stage.dirty=!0)}};var Bl=class{constructor(t,e){this.nodes=t,this.colours=e,this.points=new Float32Array(4*360*t.length),this.head=0,this.version=0,this.empty=!0}push(t){let e=this.empty?360:1;for(let i=0;i<e;i++)this.nodes.forEach((s,r)=>{let o=4*(r*360+this.head);for(let a=0;a<3;a++)this.points[o+a]=t[4*s+a]}),this.head=(this.head+1)%360;this.empty=!1,this.version++}clear(){this.empty=!0,this.version++}};var aM=84,lM=8,cM=24,hM=new Set(["fixed","velocity","table"]),uM=5,zl=class{constructor(t){this.stage=t,this.dirty=!0,this.reactions=!0,this.trails=null,this.followed=new Set,this.hover=null,this.chosen=null,this.kick=null,this.strongest=0,this.labels=[],this.posts=[],this.standing=!0}setLayout(t){let e=t.variants[0].nodes;for(let i of this.followed)i>=e&&this.followed.delete(i);this.resetTrails(),this.strongest=0,this.hover=this.kick=this.chosen=null}toggleTrail(t){this.followed.delete(t)||this.followed.add(t),this.followed.size>8&&this.followed.delete([...this.followed][0]),this.resetTrails()}resetTrails(){let t=[...this.followed],e=t.map((i,s)=>Ys(ei[(s+1)%ei.length]));this.trails=t.length?new Bl(t,e):null,this.dirty=!0}collect(){let t=[],e=[];this.labels=[],this.posts=[];let{session:i}=this.stage;return i.layout&&i.frame&&(this.addAnchors(t,e),this.addLoads(t),this.addGrabs(t,e),this.addHand(t,e)),{markers:t,arrows:e}}addAnchors(t,e){let{session:i,theme:s,anchors:r,camera:o}=this.stage,a=i.layout,l=i.frame,h=Math.min(aM,.14*o.width)*o.pose.distance/o.focal,d=0,u=0,f=[];if(a.variants.forEach((m,v)=>{let g=l.parts[v];m.anchors.forEach((p,y)=>{let T=Ni(r.shown.subarray(d,d+3));if(d+=3,g.anchors[10*y+9]<.5||!T.every(Number.isFinite))return;let[M,R,A]=T,_=p.pinned?s.pin:p.motion==="hand"?s.hand:s.anchor,E=p.pinned?14:19;t.push({x:M,y:R,z:A,kind:"eye",colour:_,size:0,pixels:E}),hM.has(p.motion)&&this.addPost(T);let k=[...g.anchors.subarray(10*y+6,10*y+9)],N=Math.hypot(...k);Number.isFinite(N)&&(u=Math.max(u,N),(v===0||this.stage.apart)&&f.push({place:T,force:k,size:N}))})}),!!this.reactions){this.strongest=Math.max(u,this.strongest*.995);for(let{place:m,force:v,size:g}of f){if(g<.04*this.strongest||g<1e-9)continue;let p=ce(m,v,h/this.strongest);e.push({from:m,to:p,colour:s.arrow,pixels:2.6,head:!0}),f.length<=lM&&this.labels.push({from:m,at:p,text:Ve(g,"N"),kind:"reaction"})}}}addPost(t){let{camera:e,theme:i,floor:s}=this.stage,r=$e(t,e.up)-s.level,o=uM*e.pose.distance/e.focal;if(!this.standing||r<2*o||this.posts.length>=2*cM)return;let a=ce(t,e.up,-r),l=ce(a,e.toward,.3*o);this.posts.push({from:t,to:a,colour:i.post,pixels:4.5,head:!1},{from:ce(l,e.up,o),to:l,colour:i.post,pixels:16,head:!1})}addLoads(t){let{session:e,theme:i,nodes:s,starts:r}=this.stage;e.layout.variants.forEach((a,l)=>{let c=a.ropes.reduce((h,d)=>h+d.mass,0);for(let h of a.loads){let d=4*(r[l]+h.index),[u,f,m]=s.shown.subarray(d,d+3),v=9+11*Math.min(1.6,Math.cbrt(h.mass/Math.max(c,1e-9)));t.push({x:u,y:f,z:m,kind:"round",colour:i.load,size:0,pixels:v})}});for(let[a,l]of[...this.followed].entries()){let[c,h,d]=s.shown.subarray(4*l,4*l+3),u=Ys(ei[(a+1)%ei.length]);t.push({x:c,y:h,z:d,kind:"round",colour:u,size:0,pixels:8})}}addGrabs(t,e){let{session:i,theme:s,nodes:r,starts:o,shifts:a}=this.stage;i.frame.parts.forEach((c,h)=>{for(let d=0;d<c.grabs.length;d+=8){let u=c.grabs[d];if(!(u>=0))continue;let f=4*(o[h]+u),m=Ni(r.shown.subarray(f,f+3)),v=ce(c.grabs.subarray(d+1,d+4),a[h]);e.push({from:m,to:v,colour:s.grab,pixels:2,head:!1}),t.push({x:v[0],y:v[1],z:v[2],kind:"ring",colour:s.grab,size:0,pixels:16});let[g,p,y]=c.grabs.subarray(d+4,d+7);h===0&&this.labels.push({from:m,at:v,text:Ve(Math.hypot(g,p,y),"N"),kind:"grab"})}})}addHand(t,e){let{theme:i}=this.stage,s=this.chosen&&Oo(this.stage,this.chosen);for(let l of[this.ringPlace(),s]){if(!l)continue;let[c,h,d]=l;t.push({x:c,y:h,z:d,kind:"ring",colour:i.hover,size:0,pixels:24})}if(!this.kick)return;let{from:r,to:o,text:a}=this.kick;e.push({from:r,to:o,colour:i.grab,pixels:3,head:!0}),this.labels.push({from:r,at:o,text:a,kind:"kick"})}ringPlace(){let{hover:t,stage:e}=this;return t===null||Array.isArray(t)?t:Oo(e,t)}get scale(){return Ve(this.strongest,"N")}};var dM=60,fM=1,Vl=class{constructor(t,e){this.session=t,this.renderer=e,this.camera=new Dl,this.nodes=new ir(4),this.anchors=new ir(0),this.range=new Fo,this.colouring="tension",this.dots=!1,this.apart=!1,this.shifts=[[0,0,0]],this.starts=[0],this.corners=new Uint8Array(0),this.theme=Yu(),this.marks=new zl(this),this.dirty=!0,this.drawn=0,this.spacing=1,this.floor=new kl(this),this.flight=null,this.follower=new Ul,this.following=!0,this.ownVersion=-1,this.axis=-1,this.past=!1,this.lookPending=!0,this.layoutNumber=-1,this.up=[0,0,1],this.sceneKey="",this.lastTime=-1/0,this.lastPush=0,this.cameraVersion=-1,this.card=()=>null,this.beforeDraw=[],this.afterDraw=[],t.on("layout",s=>this.takeLayout(s)),t.on("frame",s=>this.takeFrame(s)),t.on("broken",()=>{this.range.fresh=!0,this.past=t.broken!==null}),e.setTheme(this.theme),e.canvas.addEventListener("webglcontextrestored",()=>this.setTheme());let i=s=>{requestAnimationFrame(i),this.tick(s)};requestAnimationFrame(i)}takeLayout(t){if(this.dirty=!0,t.layout===this.layoutNumber){this.follow(t);return}this.layoutNumber=t.layout,this.starts=gl(t);let e=Ki(t),[i,s]=nr(e);this.nodes=new ir(4*i*s),this.anchors=new ir(3*t.variants.reduce((o,{anchors:a})=>o+a.length,0)),this.up=t.up,this.camera.setUp(t.up),this.renderer.setShape(Am(t)),this.corners=Rm(t),this.marks.setLayout(t);let r=`${t.scene.name} ${t.scene.preset} ${t.variants.length>1&&this.apart}`;r!==this.sceneKey&&(this.sceneKey=r,this.lookPending=!0,this.range.fresh=!0),this.shift(t)}follow({up:t,gravity:e}){t.every((s,r)=>Math.abs(s-this.up[r])<1e-6)||e.every(s=>s===0)||(this.up=t,this.camera.setUp(t),this.lookPending=!0)}shift(t){let e=this.lookPending?this.camera.first:this.camera.right;this.shifts=Cm(t,this.apart,e,2.1*t.view.radius)}setApart(t){this.apart=t;let{layout:e,frame:i}=this.session;e&&(this.shift(e),this.lookPending=!0,i&&this.takeFrame(i,!0))}takeFrame(t,e=!1){let i=this.session.layout,s=performance.now(),r=e||t.time<this.lastTime||!(t.flags&1);t.time<this.lastTime&&this.marks.trails?.clear(),(t.time<this.lastTime||t.time>this.lastTime+fM)&&(this.range.fresh=!0,this.marks.strongest=0),this.lastTime=t.time;let o=this.nodes.next(s,r),a=Ym(t,i,this.colouring,this.shifts,o);Vm(o,Ki(i),i.view),this.past=this.session.broken!==null||(t.flags&2)!==0,t.flags&2||this.range.follow(a.low,a.high,Math.min(.2,(s-this.lastPush)/1e3)),this.lastPush=s,this.gatherAnchors(t,this.anchors.next(s,r)),this.lookPending?this.look(i):this.keepInView(i,s),this.marks.trails&&this.marks.trails.push(this.nodes.to),this.dirty=!0}showInstead(t,e=0){let{frame:i}=this.session;if(!i)return;if(!t)return this.takeFrame(i,!0);let s=Float32Array.from(t.flat()),r=i.parts.map((o,a)=>a===e&&s.length===o.positions.length?{...o,positions:s}:o);this.takeFrame({...i,parts:r,flags:i.flags|2},!0)}gatherAnchors(t,e){let i=0;t.parts.forEach((s,r)=>{for(let o=0;o<s.anchors.length;o+=10)for(let a=0;a<3;a++)e[i++]=s.anchors[o+a]+this.shifts[r][a]})}look(t){this.lookPending=!1;let e=Hm(this.nodes.to,Ki(t));this.axis=Gm(e,this.camera.up,t.view.radius),this.floor.put(t,e),this.follower.clear(),this.setPose(this.firstPose(t)),this.following=!0,this.flight=null}keepInView(t,e){if(this.past)return;let{camera:i,follower:s}=this,r=Math.min(.2,(e-this.lastLook)/1e3);if(this.lastLook=e,s.take(i,this.nodes.to,Ki(t),r,t.view),this.floor.giveWay(t),i.version!==this.ownVersion&&!this.flight&&(this.following=!1),!this.following||this.flight||this.held())return;let o=s.wanted(i,this.strips());o&&this.fly(o,km)}get leastWidth(){return this.session.layout&&Ki(this.session.layout)>4e3?4:8}thickness(){let{camera:t,session:e}=this,i=e.layout?.variants.flatMap(r=>r.ropes)??[],s=Math.max(1e-9,...i.map(r=>r.diameter));return Math.max(1,this.leastWidth*t.pose.distance/t.focal/s)}held=()=>!1;lastLook=0;setPose(t){this.camera.set(t),this.ownVersion=this.camera.version}firstPose(t){let e=Wm(this.camera,this.axis),i=this.camera.framed(this.places(t),e);return this.covered(i)?this.wholePose(t,e):i}wholePose(t,e){return this.camera.framed(this.places(t),e,this.strips())}*places(t){let{to:e}=this.nodes;for(let i=0;i<Ki(t);i++)yield Ni(e.subarray(4*i,4*i+3))}fit(t={}){let{layout:e}=this.session;!e||this.nodes.empty||(this.following=!0,this.follower.clear(),this.fly(this.wholePose(e,t)))}uncover(){!this.lookPending&&this.covered(this.camera.pose)&&this.fit()}covered(t){let{layout:e}=this.session,i=this.card();if(!e||!i)return!1;let s=this.camera.at(t);for(let r=0;r<Ki(e);r++){let[o,a]=s.project(...Ni(this.nodes.to.subarray(4*r,4*r+3)));if(o>i.left&&o<i.right&&a>i.top&&a<i.bottom)return!0}return!1}strips(){let t=this.card();if(!t)return{top:0,bottom:0};let e=this.camera.height-t.top;return t.bottom<e?{top:t.bottom,bottom:0}:{top:dM,bottom:e}}fly(t,e){this.ownVersion=this.camera.version,matchMedia("(prefers-reduced-motion: reduce)").matches?this.setPose(t):this.flight=new Fl(this.camera.pose,t,performance.now(),e)}setColouring(t){this.colouring=t,this.range=new Fo,this.session.frame&&this.takeFrame(this.session.frame,!0)}setTheme(){this.theme=Yu(),this.renderer.setTheme(this.theme),this.dirty=!0}resize(t,e){let i=this.camera.width/this.camera.height,s=this.camera.version===this.ownVersion;this.camera.resize(t,e),s&&(this.ownVersion=this.camera.version),this.renderer.resize(t,e,Math.min(2,devicePixelRatio||1)),this.following&&Math.abs(t/e/i-1)>.3&&(this.lookPending=!0);let{layout:r,frame:o}=this.session;r&&o&&this.lookPending&&this.look(r),this.renderer.clear(),this.draw(!0)}tick(t){if(this.flight){let{pose:s,over:r}=this.flight.at(t);this.setPose(s),r&&(this.flight=null)}this.floor.advance();let e=this.nodes.advance(performance.now());this.anchors.advance(performance.now());let i=this.camera.version!==this.cameraVersion;(e||i||this.dirty||this.marks.dirty)&&this.draw(e||this.dirty),this.session.acknowledge()}draw(t){let{layout:e}=this.session;if(!e||this.nodes.empty)return;if(t)for(let o of this.beforeDraw)o();this.dirty=this.marks.dirty=!1,this.cameraVersion=this.camera.version;let{markers:i,arrows:s}=this.marks.collect(),r=Xm(this.camera,e,this.floor.height);this.spacing=r.spacing,this.renderer.draw({camera:this.camera,nodes:this.nodes.shown,moved:t,range:this.range,plain:this.colouring==="plain",dots:this.dots,pixels:this.leastWidth,smooth:!this.past,corners:this.corners,markers:i,arrows:s,posts:this.marks.posts,trails:this.marks.trails,ground:r}),this.drawn++;for(let o of this.afterDraw)o()}screenOf(t,e=0){let i=4*(this.starts[e]+t),{shown:s}=this.nodes,[r,o,a]=this.camera.project(s[i],s[i+1],s[i+2]);return{x:r,y:o,depth:a}}};var Zm="(max-width: 700px), (max-height: 500px)",Hl=class{constructor(t,e,i){this.session=e,this.root=t;let s=(a,l)=>W(a,{className:l,id:l});this.barHost=s("header","bar"),this.meterHost=s("section","meter"),this.scene=s("main","scene"),this.panel=s("aside","panel"),this.graphHost=s("section","graphs"),this.footer=s("footer","controls");let r=W("canvas",{id:"view",tabIndex:0,"aria-label":"The ropes"});this.scene.append(r),t.replaceChildren(this.barHost,this.meterHost,this.scene,this.panel,this.graphHost,this.footer),this.graphHost.hidden=!0,this.stage=new Vl(e,i(r)),this.labels=new Ml(this.stage,this.scene),this.notices=new wl(e,this.scene),this.legend=new Sl(this.stage,this.scene),this.views=new Ll(this.stage,this.scene),this.graphs=new fl(this.stage,this.graphHost),this.tools=new Tl(this.stage,this.scene,a=>this.follow(a)),this.pointer=new Ya(this.stage,this.stage.renderer.canvas,{use:(a,l)=>this.tools.use(a,l),menu:(a,l,c)=>this.tools.menu(a,l,c)}),this.tools.pointer=this.pointer;let o=W("div",{className:"unseen",role:"status",id:"voice"});this.scene.append(o),this.walk=new $a(this.stage,this.stage.renderer.canvas,o,(a,l,c)=>this.tools.menu(a,l,c)),this.stage.held=()=>this.pointer.down.size>0,this.meter=new bl(e,this.meterHost),this.controls=new xl(e,this.footer,()=>this.graphs.toggle()),this.tweak=new Il(e,this.panel),this.broken=new ml(e,this.scene,(...a)=>this.stage.showInstead(...a)),this.tour=new Al(e,this.scene),this.scenes=new El(e,t),this.compare=new _l(this.stage,t,this.scene,a=>this.compareColours(a)),this.help=new vl(t),this.keep=new yl(this.stage,t,this.notices),this.bar=new pl(this.barHost,{scenes:()=>this.scenes.open(),tour:()=>this.tour.start(),compare:()=>this.compare.open(),keep:a=>this.keep.open(a),help:()=>this.help.open(),theme:()=>this.toggleTheme(),panel:()=>this.togglePanel()}),this.keys=new Ga(e,this.stage.camera,this.shortcuts()),this.watchHand(),this.panel.hidden=matchMedia(Zm).matches,new ResizeObserver(()=>this.resize()).observe(this.scene),this.resize(),e.on("hello",()=>this.hello()),e.on("layout",({scene:a})=>this.bar.show(a.name)),e.on("status",({address:a})=>this.writeAddress(a)),this.asked=!1,addEventListener("hashchange",()=>this.openAddress())}shortcuts(){return{" ":()=>this.controls.toggle(),".":()=>this.controls.doStep(),r:()=>this.controls.doReset(),f:()=>this.stage.fit(),g:()=>this.graphs.toggle(),p:()=>this.togglePanel(),t:()=>this.toggleTheme(),h:()=>this.help.open(),"?":()=>this.help.open()}}watchHand(){let{source:t}=this.session,e=t.send.bind(t);t.send=i=>{e(i),["drag","move","grab"].includes(i.type)&&this.tour.handMoved()}}hello(){let{session:t}=this,e=t.hello,i=this.stage.renderer.name==="webgl"?"WebGL":"Canvas 2D";this.help.version.textContent=`Ropewalk ${e.ropewalk}, drawn with ${i}.`,this.root.dataset.mode=e.mode,this.bar.compare.hidden=!t.can("compare"),this.bar.tour.hidden=!t.can("set"),this.bar.choose.disabled=!t.can("scene");let s=t.can("set");s||(this.panel.hidden=!0),this.bar.panel.hidden=!s,!this.asked&&location.hash.slice(1)!==e.address&&this.openAddress(),this.asked=!0,this.resize()}openAddress(){let{session:t}=this,e=location.hash.slice(1);e&&e!==t.status?.address&&t.can("scene")&&t.tell({type:"scene",address:e})}writeAddress(t){!this.session.source.base||!t||location.hash.slice(1)===t||history.replaceState(null,"",`#${t}`)}follow(t){this.stage.marks.toggleTrail(t),this.graphs.rebuild(),!this.graphs.open&&this.stage.marks.followed.size===1&&!matchMedia(Zm).matches&&this.graphs.toggle(!0)}compareColours(t){this.legend.select.value=t?"plain":"tension",this.legend.choose()}togglePanel(){this.panel.hidden=!this.panel.hidden,this.resize()}toggleTheme(){Ol(document.documentElement.dataset.theme==="dark"?"light":"dark",!0),this.stage.setTheme(),this.graphs.rebuild()}resize(){this.root.classList.toggle("with-panel",!this.panel.hidden);let{clientWidth:t,clientHeight:e}=this.scene;t&&e&&this.stage.resize(t,e)}};function Km(n){let{session:t,stage:e}=n;return{app:n,session:t,stage:e,get frames(){return t.frames},get drawn(){return e.drawn},get frame(){return t.frame?.number??-1},get time(){return t.frame?.time??NaN},get renderer(){return e.renderer.name},get state(){return t.connection!=="open"?t.connection:t.frame?t.broken?"broken":t.status?.playing?"playing":"paused":"waiting"},screenOf(i,s=0){let r=e.renderer.canvas.getBoundingClientRect(),{x:o,y:a}=e.screenOf(i,s);return{x:o+r.left,y:a+r.top}},nodeAt(i,s=0){let r=t.frame?.parts[s];return r?[...r.positions.subarray(3*i,3*i+3)]:null}}}var pM=900,mM=600,gM=120,Kr=class{constructor(t,e){this.app=t,this.read=e,this.timer=0,this.known="",this.until=-1,this.coarse=[],t.graphs.wanted=()=>this.want()}want(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>this.fill(),gM)}async fill(){let{graphs:t,session:e,stage:i}=this.app,{layout:s,frame:r}=e;if(!t.open||!s||!r||r.steps<1)return;let[o,a]=[r.steps,r.time],l=Math.min(t.window,a),c=Math.min(o,Math.ceil(l*o/Math.max(a,1e-9))),h=`${s.layout} ${[...i.marks.followed]}`;(h!==this.known||o>this.until)&&(this.coarse=await this.samples(0,o,mM,s),[this.known,this.until]=[h,o]);let d=await this.samples(o-c,c,pM,s);if(e.layout!==s||!e.frame||e.frame.time<a)return;let u=d[0]?.time??a,{history:f}=t;f.clear();for(let{time:m,values:v}of this.coarse)m<u&&f.add(m,v);for(let{time:m,values:v}of d)f.add(m,v);t.take(e.frame),t.bounds()}async samples(t,e,i,s){let r=Math.max(1,Math.ceil(e/i)),o=[...this.app.stage.marks.followed];return(await this.read(t,Math.ceil(e/r),r)).filter(c=>!(c.flags&2)).map(c=>({time:c.time,values:dl(s,c,o)}))}};var Jm=40;function jm(n,t){let e=new Kr(n,(...s)=>_M(t,...s));t.jumped=()=>{n.stage.marks.trails?.clear(),e.want()};let{about:i}=t.header;n.help.window.append(W("p",{className:"faint",id:"about"},i))}async function _M(n,t,e,i){let s=n.parts[n.layout],r=[];for(let o=0;o<e;o++){let a=t+o*i;a<s.first||a>=s.first+s.frames||(r.push(Lr(n.frame(a),s.layout)),o%Jm===Jm-1&&await new Promise(l=>setTimeout(l)))}return r}var xM=.3;function Qm(n){let{session:t,stage:e}=n,i=null,s=0;t.on("frame",({time:r})=>{if(t.hello?.mode!=="replay")return;i??=new Kr(n,(...a)=>vM(n,...a));let o=r<s||r>s+xM*Math.max(1,t.status?.speed??1);s=r,o&&(e.marks.trails?.clear(),i.want())})}async function vM({session:n},t,e,i){let s=n.layout;if(e<1)return[];let r=`replay/frames.bin?first=${t}&count=${e}&every=${i}`,o=await fetch(n.source.base+r).catch(()=>null);return o?.ok?yM(await o.arrayBuffer(),s).map(a=>Lr(a,s)):[]}function yM(n,t){let e=[];for(let i=n.byteLength;i>=t.bytes;i-=t.bytes){let s=n.slice(i-t.bytes,i);if(Wa(s)!==t.layout)break;e.push(s)}return e.reverse()}var Zu=[-.3,.4],Jo=new Float64Array(3),jo=new Float64Array(3);function ig(n,t,e,i,s,r){let o=t.first+t.count-1,a=4*r;for(let l=t.first;l<o;l++){let c=4*l,h=Ku(n,c,c+4),d=l>t.first&&!i[l],u=l+1<o&&!i[l+1];d&&tg(n,c,c,h,Jo),u&&tg(n,c+4,c,h,jo);for(let f=0;f<3;f++){let m=n[c+4+f]-n[c+f];d||(Jo[f]=u?1.5*m-.5*jo[f]:m),u||(jo[f]=d?1.5*m-.5*Jo[f]:m)}eg(Jo,1.6*h),eg(jo,1.6*h);for(let f=0;f<e;f++,a+=4){let m=f/e,[v,g]=[m*m,m*m*m],[p,y,T]=[3*v-2*g,m-2*v+g,g-v];for(let M=0;M<3;M++){let R=n[c+M];s[a+M]=R+p*(n[c+4+M]-R)+y*Jo[M]+T*jo[M]}s[a+3]=n[c+3]+m*(n[c+7]-n[c+3])}}for(let l=0;l<4;l++)s[a+l]=n[4*o+l]}function tg(n,t,e,i,s){let r=Ku(n,t-4,t),o=Ku(n,t,t+4),a=Math.sqrt(i);if(!(r>0&&o>0)){for(let f=0;f<3;f++)s[f]=n[e+4+f]-n[e+f];return}let[l,c]=[Math.sqrt(r),Math.sqrt(o)],h=0;for(let f=0;f<3;f++)h+=(n[t+f]-n[t-4+f])*(n[t+4+f]-n[t+f])/(r*o);let d=Math.min(1,Math.max(0,(h-Zu[0])/(Zu[1]-Zu[0]))),u=d*d*(3-2*d);for(let f=0;f<3;f++){let[m,v,g]=[n[t-4+f],n[t+f],n[t+4+f]],p=(v-m)/l-(g-m)/(l+c)+(g-v)/c,y=n[e+4+f]-n[e+f];s[f]=y+u*(p*a-y)}}function eg(n,t){let e=Math.hypot(n[0],n[1],n[2]);if(e>t)for(let i=0;i<3;i++)n[i]*=t/e}function Ku(n,t,e){return Math.hypot(n[e]-n[t],n[e+1]-n[t+1],n[e+2]-n[t+2])}function ng(n,t,e,i){let s=4*t,[r,o,a]=[1,0,0],[l,c,h]=[i[s],i[s+1],i[s+2]],d=!1;for(let u=0;u<e;u++,s+=4){if(u>0&&u+1===e){i[s]=l,i[s+1]=c,i[s+2]=h;break}let f=n[s+4]-n[s],m=n[s+5]-n[s+1],v=n[s+6]-n[s+2],g=Math.sqrt(f*f+m*m+v*v);if(g>0){let[p,y,T]=[f/g,m/g,v/g];if(d){let A=r*p+o*y+a*T;if(A>-.999){let _=(l*p+c*y+h*T)/(1+A);l-=_*(r+p),c-=_*(o+y),h-=_*(a+T)}}[r,o,a]=[p,y,T];let M=l*r+c*o+h*a;[l,c,h]=[l-M*r,c-M*o,h-M*a];let R=Math.sqrt(l*l+c*c+h*h);R>.001||([l,c,h]=Math.abs(a)<.9?[-o,r,0]:[0,-a,o],R=Math.sqrt(l*l+c*c+h*h)),l/=R,c/=R,h/=R,d=!0}i[s]=l,i[s+1]=c,i[s+2]=h}}var MM=7,Ju=1.5,SM=8,bM=16,Jr=class{constructor(t,e){this.budget=t,this.laid=e,this.steps=0,this.every=1,this.nodes={nodes:0,ropes:[]},this.shape={nodes:0,ropes:[]},this.points=new Float32Array(4),this.normals=new Float32Array(4)}setShape(t){this.nodes=t,this.steps=0}update(t){let[e,i]=this.wanted(t),s=e!==this.steps||i!==this.every;return s&&this.build(e,i),!s&&!t.moved?!1:(this.nodes.ropes.forEach((r,o)=>{let{first:a,count:l}=this.shape.ropes[o];i>1?wM(t.nodes,r.first,r.count,i,this.points,a):e>1?ig(t.nodes,r,e,t.corners,this.points,a):this.points.set(t.nodes.subarray(4*r.first,4*(r.first+r.count)),4*a),this.framed&&ng(this.points,a,l,this.normals)}),s)}get framed(){return this.shape.nodes<=this.laid}wanted({camera:t,smooth:e,dots:i}){let{ropes:s,nodes:r}=this.nodes;if(!e||!r)return[1,1];let a=s.reduce((d,{spacing:u})=>Math.max(d,u),0)*t.focal/t.pose.distance;if(!i&&(a<Ju||this.every>1&&a<1.3*Ju)){let d=Math.min(bM,2**Math.round(Math.log2(2*Ju/a)));return[1,this.every>1&&d<4*this.every&&this.every<4*d?this.every:Math.max(2,d)]}let l=Math.max(1,Math.min(SM,Math.floor(this.budget/r))),c=Math.max(1,Math.min(l,Math.ceil(a/MM)));return[this.steps>=c&&this.steps<=Math.max(2,2*c)&&this.steps<=l?this.steps:c,1]}build(t,e){let i=this.shape.ropes.map(({first:l})=>this.normals.slice(4*l,4*l+3));[this.steps,this.every]=[t,e];let s=0,r=this.nodes.ropes.map(l=>{let c=s,h=Math.max(0,l.count-1),d=e>1?Math.ceil(h/e):h*t,u=l.count>0?d+1:0;return s+=u,{...l,first:c,count:u,spacing:l.spacing*h/Math.max(1,d)}});this.shape={nodes:s,ropes:r};let[o,a]=nr(s);this.points=new Float32Array(4*o*a),this.normals=new Float32Array(this.framed?4*o*a:4),this.framed&&r.forEach(({first:l,count:c,spacing:h},d)=>{i.length===r.length&&this.normals.set(i[d],4*l);for(let u=0;u<c;u++)this.normals[4*(l+u)+3]=u*h})}};function wM(n,t,e,i,s,r){let o=4*r;for(let l=0;l<e-1;l+=i,o+=4){let c=Math.min(l+i,e-1),h=4*(t+l),d=n[h+3];for(let u=l+1;u<c;u++)d=Math.max(d,n[4*(t+u)+3]);s[o]=n[h],s[o+1]=n[h+1],s[o+2]=n[h+2],s[o+3]=d}let a=4*(t+e-1);for(let l=0;l<4;l++)s[o+l]=n[a+l]}var Gl=14,sg=8;function rg(n,t,e){let{width:i,height:s,focal:r}=t,o=s/2-r*Math.tan(Math.min(1.5,t.pose.elevation)),a=c=>Math.min(1,Math.max(0,c/s)),l=n.createLinearGradient(0,0,0,s);l.addColorStop(0,Ye(o>0?e.background:e.ground)),l.addColorStop(a(o),Ye(o>0?e.horizon:e.ground)),l.addColorStop(a(o+.35*s),Ye(e.ground)),n.fillStyle=l,n.fillRect(0,0,i,s)}function og(n,t,e,i){n.lineWidth=1;let s=[[],[],[]];for(let[r,o]of[[t.first,t.second],[t.second,t.first]])for(let a=-Gl;a<=Gl;a++){let l=ce(e.center,r,a*e.spacing);for(let c=0;c<sg;c++){let[h,d]=[c,c+1].map(v=>(2*v/sg-1)*Gl),u=Math.hypot(a,(h+d)/2)/Gl;if(u>.95)continue;let f=t.project(...ce(l,o,h*e.spacing)),m=t.project(...ce(l,o,d*e.spacing));f[2]<=.02*t.pose.distance||m[2]<=.02*t.pose.distance||s[u<.45?0:u<.7?1:2].push(f[0],f[1],m[0],m[1])}}s.forEach((r,o)=>{n.strokeStyle=Ye(i.grid,[.8,.5,.2][o]),n.beginPath();for(let a=0;a<r.length;a+=4)n.moveTo(r[a],r[a+1]),n.lineTo(r[a+2],r[a+3]);n.stroke()})}function ag(n,t,e){let[i,s,r]=t.project(e.x,e.y,e.z);if(r<=0)return;let o=.5*Math.max(e.pixels,e.size*t.focal/r),a=e.colour.map(l=>.72*l);if(n.beginPath(),e.kind==="ring"){n.arc(i,s,o-1.2,0,2*Math.PI),n.lineWidth=2.4,n.strokeStyle=Ye(e.colour),n.stroke();return}if(e.kind==="eye"){n.arc(i,s,.7*o,0,2*Math.PI);for(let[l,c]of[[.65,a],[.4,e.colour]])n.lineWidth=l*o,n.strokeStyle=Ye(c),n.stroke();return}n.arc(i,s,o,0,2*Math.PI),n.fillStyle=Ye(e.colour),n.fill(),n.lineWidth=1.5,n.strokeStyle=Ye(a),n.stroke()}function ju(n,t,e){let[i,s,r]=t.project(e.from[0],e.from[1],e.from[2]),[o,a,l]=t.project(e.to[0],e.to[1],e.to[2]);if(r<=0||l<=0)return;let c=Math.hypot(o-i,a-s);if(c<1)return;let[h,d]=[(o-i)/c,(a-s)/c],u=e.head?Math.min(.5*c,5.5*e.pixels):0;if(n.lineCap="butt",n.lineWidth=e.pixels,n.strokeStyle=n.fillStyle=Ye(e.colour),n.beginPath(),n.moveTo(i,s),n.lineTo(o-u*h,a-u*d),n.stroke(),n.lineCap="round",!u)return;let f=2.2*e.pixels;n.beginPath(),n.moveTo(o,a),n.lineTo(o-u*h-f*d,a-u*d+f*h),n.lineTo(o-u*h+f*d,a-u*d-f*h),n.fill()}var Qo=32,EM=1200,Qu=6,ta=class{constructor(t){let e=t.getContext("2d",{alpha:!1});if(!e)throw new Error("no canvas to draw on");this.name="canvas",this.canvas=t,this.context=e,this.colours=[],this.line=new Jr(EM,0),this.shape={nodes:0,ropes:[]},this.seen=new Float32Array(0),this.batch=new Uint8Array(0),this.ratio=1,this.theme=null}setShape(t){this.line.setShape(t)}setTheme(t){this.theme=t;let e=Dr(t.dark);this.colours=Array.from({length:Qo},(i,s)=>Ye(e[Math.round(s/(Qo-1)*(e.length-1))]))}resize(t,e,i){this.canvas.width=Math.round(t*i),this.canvas.height=Math.round(e*i),this.ratio=i}clear(){let{context:t,canvas:e,theme:i}=this;t.setTransform(1,0,0,1,0,0),t.fillStyle=i?Ye(i.background):"#888888",t.fillRect(0,0,e.width,e.height)}follow(t){this.line.update(t)&&(this.shape=this.line.shape,this.seen=new Float32Array(3*this.shape.nodes),this.batch=new Uint8Array(this.shape.nodes))}draw(t){let{context:e,theme:i}=this;if(i){this.follow(t),this.clear(),e.setTransform(this.ratio,0,0,this.ratio,0,0),e.lineJoin="round",e.lineCap="round",rg(e,t.camera,i),og(e,t.camera,t.ground,i),this.shadows(t,i);for(let s of t.posts)ju(e,t.camera,s);this.project(t,null),t.trails&&!t.trails.empty&&this.trails(t),this.ropes(t),t.dots&&this.dots(i);for(let s of t.markers)ag(e,t.camera,s);for(let s of t.arrows)ju(e,t.camera,s)}}shadows(t,e){let{context:i}=this;this.project(t,t.ground.height),i.strokeStyle=Ye(e.shadow,e.dark?.5:.16);for(let s of this.shape.ropes)i.lineWidth=this.width(s,t)*1.2,i.beginPath(),this.path(s),i.stroke()}project(t,e){let{seen:i}=this,{camera:s}=t,{points:r}=this.line,o=s.view,[a,l,c]=s.up,h=ce(s.light,s.up,-$e(s.light,s.up)),[d,u,f]=ce(s.up,h,.75/$e(s.light,s.up)),[m,v,g]=[s.width/2,s.height/2,s.focal];for(let p=0;p<this.shape.nodes;p++){let[y,T,M]=[r[4*p],r[4*p+1],r[4*p+2]];if(e!==null){let _=y*a+T*l+M*c-e;y-=_*d,T-=_*u,M-=_*f}let R=-(o[2]*y+o[6]*T+o[10]*M+o[14]),A=g/Math.max(R,1e-9);i[3*p]=m+(o[0]*y+o[4]*T+o[8]*M+o[12])*A,i[3*p+1]=v-(o[1]*y+o[5]*T+o[9]*M+o[13])*A,i[3*p+2]=r[4*p+3]>1e30?-1:R}}width(t,e){let i=Math.max(1e-9,this.seen[3*(t.first+(t.count>>1))+2]);return Math.max(e.pixels,2*t.radius*e.camera.focal/i)}path(t){let{context:e,seen:i}=this,s=!1;for(let r=t.first;r<t.first+t.count;r++){let o=i[3*r+2]<=0;s&&!o?e.lineTo(i[3*r],i[3*r+1]):e.moveTo(i[3*r],i[3*r+1]),s=!o}}ropes(t){let{context:e}=this,i=this.theme;for(let s of this.shape.ropes){let r=this.width(s,t);if(t.plain){e.lineWidth=r,e.strokeStyle=Ye(s.colour),e.beginPath(),this.path(s),e.stroke();continue}this.coloured(s,t,r),r>6&&(e.lineWidth=r*.25,e.strokeStyle=i.dark?"rgba(255, 255, 255, 0.18)":"rgba(255, 255, 255, 0.3)",e.beginPath(),this.path(s),e.stroke())}}coloured(t,e,i){let{context:s,seen:r,batch:o}=this,{points:a}=this.line,{low:l,high:c}=e.range,h=Qo/Math.max(c-l,1e-30),d=t.first+t.count-1;for(let u=t.first;u<d;u++){let f=.5*(a[4*u+3]+a[4*u+7]);o[u]=Math.min(Qo-1,Math.max(0,Math.floor((f-l)*h)))}s.lineWidth=i;for(let u=0;u<Qo;u++){let f=!1,m=!1;for(let v=t.first;v<d;v++){if(!(o[v]===u)||!(r[3*v+2]>0&&r[3*v+5]>0)){f=!1;continue}m||s.beginPath(),f||s.moveTo(r[3*v],r[3*v+1]),s.lineTo(r[3*v+3],r[3*v+4]),f=m=!0}m&&(s.strokeStyle=this.colours[u],s.stroke())}}dots(t){let{context:e,seen:i}=this;e.fillStyle=Ye(t.node),e.beginPath();for(let{first:s,count:r}of this.shape.ropes)for(let o=s;o<s+r;o+=this.line.steps)i[3*o+2]<=0||(e.moveTo(i[3*o]+2.2,i[3*o+1]),e.arc(i[3*o],i[3*o+1],2.2,0,2*Math.PI));e.fill()}trails(t){let e=t.trails,{context:i}=this;i.lineWidth=2.5;let s=360/Qu;e.nodes.forEach((r,o)=>{for(let a=0;a<Qu;a++){i.strokeStyle=Ye(e.colours[o],.7*((a+1)/Qu)**2),i.beginPath();for(let l=a*s;l<=Math.min((a+1)*s,359);l++){let c=4*(o*360+(e.head+l)%360),h=e.points,[d,u,f]=t.camera.project(h[c],h[c+1],h[c+2]);f>0&&i.lineTo(d,u)}i.stroke()}})}dispose(){}};var Ig=0,Rd=1,Lg=2;var ya=1,Ng=2,yo=3,Gs=0,Xi=1,Mn=2,xs=0,Mo=1,Cd=2,Pd=3,Id=4,Xc=5;var pr=100,Dg=101,Fg=102,$c=103,Ug=104,Og=200,Ma=201,kg=202,Bg=203,Ld=204,Nd=205,zg=206,Vg=207,Hg=208,Gg=209,Wg=210,Xg=211,$g=212,qg=213,Yg=214,pc=0,mc=1,gc=2,fo=3,_c=4,xc=5,vc=6,yc=7,Dd=0,Zg=1,Kg=2,Jn=0,Fd=1,Ud=2,Od=3,kd=4,Bd=5,zd=6,Vd=7;var Hd=300,mr=301,So=302,qc=303,Yc=304,Mc=1e3,qn=1001,Sc=1002,pi=1003,Jg=1004;var Sa=1005;var Ci=1006,Zc=1007;var vs=1008;var dn=1009,Gd=1010,Wd=1011,bo=1012,Kc=1013,Dn=1014,$i=1015,Fn=1016,Jc=1017,jc=1018,gr=1020,Xd=35902,$d=35899,qd=1021,Yd=1022,qi=1023,ms=1026,ys=1027,Zd=1028,Qc=1029,Ws=1030,th=1031;var eh=1033,ba=33776,wa=33777,Ea=33778,Ta=33779,ih=35840,nh=35841,sh=35842,rh=35843,oh=36196,ah=37492,lh=37496,ch=37488,hh=37489,Aa=37490,uh=37491,dh=37808,fh=37809,ph=37810,mh=37811,gh=37812,_h=37813,xh=37814,vh=37815,yh=37816,Mh=37817,Sh=37818,bh=37819,wh=37820,Eh=37821,Th=36492,Ah=36494,Rh=36495,Ch=36283,Ph=36284,Ra=36285,Ih=36286;var oa=2300,bc=2301,dc=2302,Md=2303,Sd=2400,bd=2401,wd=2402;var jg=3200;var Kd=0,Qg=1,Ms="",ln="srgb",Us="srgb-linear",aa="linear",Ee="srgb";var fc=7680;var t0=519,e0=512,i0=513,n0=514,Jd=515,s0=516,r0=517,jd=518,Qd=519,o0=35044,Ca=35048;var Pa="300 es",vn=2e3,la=2001;function TM(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function AM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ca(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function a0(){let n=ca("canvas");return n.style.display="block",n}var lg={},po=null;function tf(...n){let t="THREE."+n.shift();po?po("log",t,...n):console.log(t,...n)}function l0(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Yt(...n){n=l0(n);let t="THREE."+n.shift();if(po)po("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function jt(...n){n=l0(n);let t="THREE."+n.shift();if(po)po("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function ra(...n){let t=n.join(" ");t in lg||(lg[t]=!0,Yt(...n))}function c0(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var h0={[pc]:pc,[gc]:vc,[_c]:_c,[fo]:xc,[mc]:mc,[vc]:gc,[yc]:yc,[xc]:fo},Yn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Fi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var td=Math.PI/180,wc=180/Math.PI;function Ia(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Fi[n&255]+Fi[n>>8&255]+Fi[n>>16&255]+Fi[n>>24&255]+"-"+Fi[t&255]+Fi[t>>8&255]+"-"+Fi[t>>16&15|64]+Fi[t>>24&255]+"-"+Fi[e&63|128]+Fi[e>>8&255]+"-"+Fi[e>>16&255]+Fi[e>>24&255]+Fi[i&255]+Fi[i>>8&255]+Fi[i>>16&255]+Fi[i>>24&255]).toLowerCase()}function xe(n,t,e){return Math.max(t,Math.min(e,n))}function RM(n,t){return(n%t+t)%t}function ed(n,t,e){return(1-e)*n+e*t}function u0(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function ef(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function CM(n,t){if(t.constructor===Float32Array)return n;let e=ef(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function PM(n,t){if(t.constructor===Float32Array)return n;let e=ef(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var ge=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(xe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Zn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],d=i[s+3],u=r[o+0],f=r[o+1],m=r[o+2],v=r[o+3];if(d!==v||l!==u||c!==f||h!==m){let g=l*u+c*f+h*m+d*v;g<0&&(u=-u,f=-f,m=-m,v=-v,g=-g);let p=1-a;if(g<.9995){let y=Math.acos(g),T=Math.sin(y);p=Math.sin(p*y)/T,a=Math.sin(a*y)/T,l=l*p+u*a,c=c*p+f*a,h=h*p+m*a,d=d*p+v*a}else{l=l*p+u*a,c=c*p+f*a,h=h*p+m*a,d=d*p+v*a;let y=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=y,c*=y,h*=y,d*=y}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],d=r[o],u=r[o+1],f=r[o+2],m=r[o+3];return t[e]=a*m+h*d+l*f-c*u,t[e+1]=l*m+h*u+c*d-a*f,t[e+2]=c*m+h*f+a*u-l*d,t[e+3]=h*m-a*d-l*u-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),d=a(r/2),u=l(i/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*f*m,this._y=c*f*d-u*h*m,this._z=c*h*m+u*f*d,this._w=c*h*d-u*f*m;break;case"YXZ":this._x=u*h*d+c*f*m,this._y=c*f*d-u*h*m,this._z=c*h*m-u*f*d,this._w=c*h*d+u*f*m;break;case"ZXY":this._x=u*h*d-c*f*m,this._y=c*f*d+u*h*m,this._z=c*h*m+u*f*d,this._w=c*h*d-u*f*m;break;case"ZYX":this._x=u*h*d-c*f*m,this._y=c*f*d+u*h*m,this._z=c*h*m-u*f*d,this._w=c*h*d+u*f*m;break;case"YZX":this._x=u*h*d+c*f*m,this._y=c*f*d+u*h*m,this._z=c*h*m-u*f*d,this._w=c*h*d-u*f*m;break;case"XZY":this._x=u*h*d-c*f*m,this._y=c*f*d-u*h*m,this._z=c*h*m+u*f*d,this._w=c*h*d+u*f*m;break;default:Yt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],d=e[10],u=i+a+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>d){let f=2*Math.sqrt(1+i-a-d);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-i-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+d-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(xe(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},J=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(cg.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(cg.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),d=2*(r*i-o*e);return this.x=e+l*c+o*d-a*h,this.y=i+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return id.copy(this).projectOnVector(t),this.sub(id)}reflect(t){return this.sub(id.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(xe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},id=new J,cg=new Zn,Qt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],d=i[7],u=i[2],f=i[5],m=i[8],v=s[0],g=s[3],p=s[6],y=s[1],T=s[4],M=s[7],R=s[2],A=s[5],_=s[8];return r[0]=o*v+a*y+l*R,r[3]=o*g+a*T+l*A,r[6]=o*p+a*M+l*_,r[1]=c*v+h*y+d*R,r[4]=c*g+h*T+d*A,r[7]=c*p+h*M+d*_,r[2]=u*v+f*y+m*R,r[5]=u*g+f*T+m*A,r[8]=u*p+f*M+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=h*o-a*c,u=a*l-h*r,f=c*r-o*l,m=e*d+i*u+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/m;return t[0]=d*v,t[1]=(s*c-h*i)*v,t[2]=(a*i-s*o)*v,t[3]=u*v,t[4]=(h*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=f*v,t[7]=(i*l-c*e)*v,t[8]=(o*e-i*r)*v,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return ra("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(nd.makeScale(t,e)),this}rotate(t){return ra("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(nd.makeRotation(-t)),this}translate(t,e){return ra("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(nd.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},nd=new Qt,hg=new Qt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ug=new Qt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function IM(){let n={enabled:!0,workingColorSpace:Us,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ee&&(s.r=ps(s.r),s.g=ps(s.g),s.b=ps(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ee&&(s.r=uo(s.r),s.g=uo(s.g),s.b=uo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ms?aa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Us]:{primaries:t,whitePoint:i,transfer:aa,toXYZ:hg,fromXYZ:ug,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ln},outputColorSpaceConfig:{drawingBufferColorSpace:ln}},[ln]:{primaries:t,whitePoint:i,transfer:Ee,toXYZ:hg,fromXYZ:ug,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ln}}}),n}var me=IM();function ps(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function uo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var jr,Ec=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{jr===void 0&&(jr=ca("canvas")),jr.width=t.width,jr.height=t.height;let s=jr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=jr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ca("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ps(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ps(e[i]/255)*255):e[i]=ps(e[i]);return{data:e,width:t.width,height:t.height}}else return Yt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},LM=0,mo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:LM++}),this.uuid=Ia(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(sd(s[o].image)):r.push(sd(s[o]))}else r=sd(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function sd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Ec.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Yt("Texture: Unable to serialize Texture."),{})}var NM=0,rd=new J,Ji=class n extends Yn{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=qn,s=qn,r=Ci,o=vs,a=qi,l=dn,c=n.DEFAULT_ANISOTROPY,h=Ms){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:NM++}),this.uuid=Ia(),this.name="",this.source=new mo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ge(0,0),this.repeat=new ge(1,1),this.center=new ge(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Qt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(rd).x}get height(){return this.source.getSize(rd).y}get depth(){return this.source.getSize(rd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Yt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Yt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Hd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Mc:t.x=t.x-Math.floor(t.x);break;case qn:t.x=t.x<0?0:1;break;case Sc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Mc:t.y=t.y-Math.floor(t.y);break;case qn:t.y=t.y<0?0:1;break;case Sc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Ji.DEFAULT_IMAGE=null;Ji.DEFAULT_MAPPING=Hd;Ji.DEFAULT_ANISOTROPY=1;var Ze=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],m=l[9],v=l[2],g=l[6],p=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-v)<.01&&Math.abs(m-g)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+v)<.1&&Math.abs(m+g)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let T=(c+1)/2,M=(f+1)/2,R=(p+1)/2,A=(h+u)/4,_=(d+v)/4,E=(m+g)/4;return T>M&&T>R?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=A/i,r=_/i):M>R?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=A/s,r=E/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=_/r,s=E/r),this.set(i,s,r,e),this}let y=Math.sqrt((g-m)*(g-m)+(d-v)*(d-v)+(u-h)*(u-h));return Math.abs(y)<.001&&(y=1),this.x=(g-m)/y,this.y=(d-v)/y,this.z=(u-h)/y,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this.w=xe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this.w=xe(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Tc=class extends Yn{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ci,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Ze(0,0,t,e),this.scissorTest=!1,this.viewport=new Ze(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Ji({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ci,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new mo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Wi=class extends Tc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},ha=class extends Ji{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=pi,this.minFilter=pi,this.wrapR=qn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ac=class extends Ji{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=pi,this.minFilter=pi,this.wrapR=qn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Ue=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,h,d,u,f,m,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,d,u,f,m,v,g)}set(t,e,i,s,r,o,a,l,c,h,d,u,f,m,v,g){let p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=d,p[14]=u,p[3]=f,p[7]=m,p[11]=v,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Qr.setFromMatrixColumn(t,0).length(),r=1/Qr.setFromMatrixColumn(t,1).length(),o=1/Qr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=o*h,f=o*d,m=a*h,v=a*d;e[0]=l*h,e[4]=-l*d,e[8]=c,e[1]=f+m*c,e[5]=u-v*c,e[9]=-a*l,e[2]=v-u*c,e[6]=m+f*c,e[10]=o*l}else if(t.order==="YXZ"){let u=l*h,f=l*d,m=c*h,v=c*d;e[0]=u+v*a,e[4]=m*a-f,e[8]=o*c,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=f*a-m,e[6]=v+u*a,e[10]=o*l}else if(t.order==="ZXY"){let u=l*h,f=l*d,m=c*h,v=c*d;e[0]=u-v*a,e[4]=-o*d,e[8]=m+f*a,e[1]=f+m*a,e[5]=o*h,e[9]=v-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let u=o*h,f=o*d,m=a*h,v=a*d;e[0]=l*h,e[4]=m*c-f,e[8]=u*c+v,e[1]=l*d,e[5]=v*c+u,e[9]=f*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let u=o*l,f=o*c,m=a*l,v=a*c;e[0]=l*h,e[4]=v-u*d,e[8]=m*d+f,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*d+m,e[10]=u-v*d}else if(t.order==="XZY"){let u=o*l,f=o*c,m=a*l,v=a*c;e[0]=l*h,e[4]=-d,e[8]=c*h,e[1]=u*d+v,e[5]=o*h,e[9]=f*d-m,e[2]=m*d-f,e[6]=a*h,e[10]=v*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(DM,t,FM)}lookAt(t,e,i){let s=this.elements;return on.subVectors(t,e),on.lengthSq()===0&&(on.z=1),on.normalize(),Ps.crossVectors(i,on),Ps.lengthSq()===0&&(Math.abs(i.z)===1?on.x+=1e-4:on.z+=1e-4,on.normalize(),Ps.crossVectors(i,on)),Ps.normalize(),Wl.crossVectors(on,Ps),s[0]=Ps.x,s[4]=Wl.x,s[8]=on.x,s[1]=Ps.y,s[5]=Wl.y,s[9]=on.y,s[2]=Ps.z,s[6]=Wl.z,s[10]=on.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],d=i[5],u=i[9],f=i[13],m=i[2],v=i[6],g=i[10],p=i[14],y=i[3],T=i[7],M=i[11],R=i[15],A=s[0],_=s[4],E=s[8],k=s[12],N=s[1],I=s[5],V=s[9],G=s[13],D=s[2],H=s[6],Z=s[10],z=s[14],ct=s[3],K=s[7],Q=s[11],st=s[15];return r[0]=o*A+a*N+l*D+c*ct,r[4]=o*_+a*I+l*H+c*K,r[8]=o*E+a*V+l*Z+c*Q,r[12]=o*k+a*G+l*z+c*st,r[1]=h*A+d*N+u*D+f*ct,r[5]=h*_+d*I+u*H+f*K,r[9]=h*E+d*V+u*Z+f*Q,r[13]=h*k+d*G+u*z+f*st,r[2]=m*A+v*N+g*D+p*ct,r[6]=m*_+v*I+g*H+p*K,r[10]=m*E+v*V+g*Z+p*Q,r[14]=m*k+v*G+g*z+p*st,r[3]=y*A+T*N+M*D+R*ct,r[7]=y*_+T*I+M*H+R*K,r[11]=y*E+T*V+M*Z+R*Q,r[15]=y*k+T*G+M*z+R*st,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],d=t[6],u=t[10],f=t[14],m=t[3],v=t[7],g=t[11],p=t[15],y=l*f-c*u,T=a*f-c*d,M=a*u-l*d,R=o*f-c*h,A=o*u-l*h,_=o*d-a*h;return e*(v*y-g*T+p*M)-i*(m*y-g*R+p*A)+s*(m*T-v*R+p*_)-r*(m*M-v*A+g*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=t[9],u=t[10],f=t[11],m=t[12],v=t[13],g=t[14],p=t[15],y=e*a-i*o,T=e*l-s*o,M=e*c-r*o,R=i*l-s*a,A=i*c-r*a,_=s*c-r*l,E=h*v-d*m,k=h*g-u*m,N=h*p-f*m,I=d*g-u*v,V=d*p-f*v,G=u*p-f*g,D=y*G-T*V+M*I+R*N-A*k+_*E;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/D;return t[0]=(a*G-l*V+c*I)*H,t[1]=(s*V-i*G-r*I)*H,t[2]=(v*_-g*A+p*R)*H,t[3]=(u*A-d*_-f*R)*H,t[4]=(l*N-o*G-c*k)*H,t[5]=(e*G-s*N+r*k)*H,t[6]=(g*M-m*_-p*T)*H,t[7]=(h*_-u*M+f*T)*H,t[8]=(o*V-a*N+c*E)*H,t[9]=(i*N-e*V-r*E)*H,t[10]=(m*A-v*M+p*y)*H,t[11]=(d*M-h*A-f*y)*H,t[12]=(a*k-o*I-l*E)*H,t[13]=(e*I-i*k+s*E)*H,t[14]=(v*T-m*R-g*y)*H,t[15]=(h*R-d*T+u*y)*H,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,d=a+a,u=r*c,f=r*h,m=r*d,v=o*h,g=o*d,p=a*d,y=l*c,T=l*h,M=l*d,R=i.x,A=i.y,_=i.z;return s[0]=(1-(v+p))*R,s[1]=(f+M)*R,s[2]=(m-T)*R,s[3]=0,s[4]=(f-M)*A,s[5]=(1-(u+p))*A,s[6]=(g+y)*A,s[7]=0,s[8]=(m+T)*_,s[9]=(g-y)*_,s[10]=(1-(u+v))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Qr.set(s[0],s[1],s[2]).length(),a=Qr.set(s[4],s[5],s[6]).length(),l=Qr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Pn.copy(this);let c=1/o,h=1/a,d=1/l;return Pn.elements[0]*=c,Pn.elements[1]*=c,Pn.elements[2]*=c,Pn.elements[4]*=h,Pn.elements[5]*=h,Pn.elements[6]*=h,Pn.elements[8]*=d,Pn.elements[9]*=d,Pn.elements[10]*=d,e.setFromRotationMatrix(Pn),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=vn,l=!1){let c=this.elements,h=2*r/(e-t),d=2*r/(i-s),u=(e+t)/(e-t),f=(i+s)/(i-s),m,v;if(l)m=r/(o-r),v=o*r/(o-r);else if(a===vn)m=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===la)m=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=vn,l=!1){let c=this.elements,h=2/(e-t),d=2/(i-s),u=-(e+t)/(e-t),f=-(i+s)/(i-s),m,v;if(l)m=1/(o-r),v=o/(o-r);else if(a===vn)m=-2/(o-r),v=-(o+r)/(o-r);else if(a===la)m=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Qr=new J,Pn=new Ue,DM=new J(0,0,0),FM=new J(1,1,1),Ps=new J,Wl=new J,on=new J,dg=new Ue,fg=new Zn,Os=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(xe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xe(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(xe(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xe(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-xe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Yt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return dg.makeRotationFromQuaternion(t),this.setFromRotationMatrix(dg,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return fg.setFromEuler(this),this.setFromQuaternion(fg,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Os.DEFAULT_ORDER="XYZ";var ua=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},UM=0,pg=new J,to=new Zn,cs=new Ue,Xl=new J,ea=new J,OM=new J,kM=new Zn,mg=new J(1,0,0),gg=new J(0,1,0),_g=new J(0,0,1),xg={type:"added"},BM={type:"removed"},eo={type:"childadded",child:null},od={type:"childremoved",child:null},hn=class n extends Yn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:UM++}),this.uuid=Ia(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new J,e=new Os,i=new Zn,s=new J(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ue},normalMatrix:{value:new Qt}}),this.matrix=new Ue,this.matrixWorld=new Ue,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ua,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return to.setFromAxisAngle(t,e),this.quaternion.multiply(to),this}rotateOnWorldAxis(t,e){return to.setFromAxisAngle(t,e),this.quaternion.premultiply(to),this}rotateX(t){return this.rotateOnAxis(mg,t)}rotateY(t){return this.rotateOnAxis(gg,t)}rotateZ(t){return this.rotateOnAxis(_g,t)}translateOnAxis(t,e){return pg.copy(t).applyQuaternion(this.quaternion),this.position.add(pg.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(mg,t)}translateY(t){return this.translateOnAxis(gg,t)}translateZ(t){return this.translateOnAxis(_g,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(cs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Xl.copy(t):Xl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ea.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?cs.lookAt(ea,Xl,this.up):cs.lookAt(Xl,ea,this.up),this.quaternion.setFromRotationMatrix(cs),s&&(cs.extractRotation(s.matrixWorld),to.setFromRotationMatrix(cs),this.quaternion.premultiply(to.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(jt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(xg),eo.child=t,this.dispatchEvent(eo),eo.child=null):jt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(BM),od.child=t,this.dispatchEvent(od),od.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),cs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),cs.multiply(t.parent.matrixWorld)),t.applyMatrix4(cs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(xg),eo.child=t,this.dispatchEvent(eo),eo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ea,t,OM),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ea,kM,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),d=o(t.shapes),u=o(t.skeletons),f=o(t.animations),m=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),d.length>0&&(i.shapes=d),u.length>0&&(i.skeletons=u),f.length>0&&(i.animations=f),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};hn.DEFAULT_UP=new J(0,1,0);hn.DEFAULT_MATRIX_AUTO_UPDATE=!0;hn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var lr=class extends hn{constructor(){super(),this.isGroup=!0,this.type="Group"}},zM={type:"move"},go=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new lr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new lr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new J,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new J),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new lr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new J,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new J,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let v of t.hand.values()){let g=e.getJointPose(v,i),p=this._getHandJoint(c,v);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,m=.005;c.inputState.pinching&&u>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(zM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new lr;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},d0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Is={h:0,s:0,l:0},$l={h:0,s:0,l:0};function ad(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var _e=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ln){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,me.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=me.workingColorSpace){return this.r=t,this.g=e,this.b=i,me.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=me.workingColorSpace){if(t=RM(t,1),e=xe(e,0,1),i=xe(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=ad(o,r,t+1/3),this.g=ad(o,r,t),this.b=ad(o,r,t-1/3)}return me.colorSpaceToWorking(this,s),this}setStyle(t,e=ln){function i(r){r!==void 0&&parseFloat(r)<1&&Yt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Yt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Yt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ln){let i=d0[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Yt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ps(t.r),this.g=ps(t.g),this.b=ps(t.b),this}copyLinearToSRGB(t){return this.r=uo(t.r),this.g=uo(t.g),this.b=uo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ln){return me.workingToColorSpace(Ui.copy(this),t),Math.round(xe(Ui.r*255,0,255))*65536+Math.round(xe(Ui.g*255,0,255))*256+Math.round(xe(Ui.b*255,0,255))}getHexString(t=ln){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=me.workingColorSpace){me.workingToColorSpace(Ui.copy(this),e);let i=Ui.r,s=Ui.g,r=Ui.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=me.workingColorSpace){return me.workingToColorSpace(Ui.copy(this),e),t.r=Ui.r,t.g=Ui.g,t.b=Ui.b,t}getStyle(t=ln){me.workingToColorSpace(Ui.copy(this),t);let e=Ui.r,i=Ui.g,s=Ui.b;return t!==ln?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Is),this.setHSL(Is.h+t,Is.s+e,Is.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Is),t.getHSL($l);let i=ed(Is.h,$l.h,e),s=ed(Is.s,$l.s,e),r=ed(Is.l,$l.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ui=new _e;_e.NAMES=d0;var cr=class extends hn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Os,this.environmentIntensity=1,this.environmentRotation=new Os,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},In=new J,hs=new J,ld=new J,us=new J,io=new J,no=new J,vg=new J,cd=new J,hd=new J,ud=new J,dd=new Ze,fd=new Ze,pd=new Ze,Fs=class n{constructor(t=new J,e=new J,i=new J){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),In.subVectors(t,e),s.cross(In);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){In.subVectors(s,e),hs.subVectors(i,e),ld.subVectors(t,e);let o=In.dot(In),a=In.dot(hs),l=In.dot(ld),c=hs.dot(hs),h=hs.dot(ld),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(c*l-a*h)*u,m=(o*h-a*l)*u;return r.set(1-f-m,m,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,us)===null?!1:us.x>=0&&us.y>=0&&us.x+us.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,us)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,us.x),l.addScaledVector(o,us.y),l.addScaledVector(a,us.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return dd.setScalar(0),fd.setScalar(0),pd.setScalar(0),dd.fromBufferAttribute(t,e),fd.fromBufferAttribute(t,i),pd.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(dd,r.x),o.addScaledVector(fd,r.y),o.addScaledVector(pd,r.z),o}static isFrontFacing(t,e,i,s){return In.subVectors(i,e),hs.subVectors(t,e),In.cross(hs).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return In.subVectors(this.c,this.b),hs.subVectors(this.a,this.b),In.cross(hs).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;io.subVectors(s,i),no.subVectors(r,i),cd.subVectors(t,i);let l=io.dot(cd),c=no.dot(cd);if(l<=0&&c<=0)return e.copy(i);hd.subVectors(t,s);let h=io.dot(hd),d=no.dot(hd);if(h>=0&&d<=h)return e.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(i).addScaledVector(io,o);ud.subVectors(t,r);let f=io.dot(ud),m=no.dot(ud);if(m>=0&&f<=m)return e.copy(r);let v=f*c-l*m;if(v<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(i).addScaledVector(no,a);let g=h*m-f*d;if(g<=0&&d-h>=0&&f-m>=0)return vg.subVectors(r,s),a=(d-h)/(d-h+(f-m)),e.copy(s).addScaledVector(vg,a);let p=1/(g+v+u);return o=v*p,a=u*p,e.copy(i).addScaledVector(io,o).addScaledVector(no,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},ks=class{constructor(t=new J(1/0,1/0,1/0),e=new J(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ln.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ln.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ln.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ln):Ln.fromBufferAttribute(r,o),Ln.applyMatrix4(t.matrixWorld),this.expandByPoint(Ln);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),ql.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),ql.copy(i.boundingBox)),ql.applyMatrix4(t.matrixWorld),this.union(ql)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ln),Ln.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ia),Yl.subVectors(this.max,ia),so.subVectors(t.a,ia),ro.subVectors(t.b,ia),oo.subVectors(t.c,ia),Ls.subVectors(ro,so),Ns.subVectors(oo,ro),sr.subVectors(so,oo);let e=[0,-Ls.z,Ls.y,0,-Ns.z,Ns.y,0,-sr.z,sr.y,Ls.z,0,-Ls.x,Ns.z,0,-Ns.x,sr.z,0,-sr.x,-Ls.y,Ls.x,0,-Ns.y,Ns.x,0,-sr.y,sr.x,0];return!md(e,so,ro,oo,Yl)||(e=[1,0,0,0,1,0,0,0,1],!md(e,so,ro,oo,Yl))?!1:(Zl.crossVectors(Ls,Ns),e=[Zl.x,Zl.y,Zl.z],md(e,so,ro,oo,Yl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ln).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ln).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ds[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ds[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ds[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ds[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ds[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ds[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ds[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ds[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ds),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ds=[new J,new J,new J,new J,new J,new J,new J,new J],Ln=new J,ql=new ks,so=new J,ro=new J,oo=new J,Ls=new J,Ns=new J,sr=new J,ia=new J,Yl=new J,Zl=new J,rr=new J;function md(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){rr.fromArray(n,r);let a=s.x*Math.abs(rr.x)+s.y*Math.abs(rr.y)+s.z*Math.abs(rr.z),l=t.dot(rr),c=e.dot(rr),h=i.dot(rr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var fi=new J,Kl=new ge,VM=0,si=class extends Yn{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:VM++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=o0,this.updateRanges=[],this.gpuType=$i,this.version=0,this._normalizationScale=t!==void 0?ef(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Kl.fromBufferAttribute(this,e),Kl.applyMatrix3(t),this.setXY(e,Kl.x,Kl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)fi.fromBufferAttribute(this,e),fi.applyMatrix3(t),this.setXYZ(e,fi.x,fi.y,fi.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)fi.fromBufferAttribute(this,e),fi.applyMatrix4(t),this.setXYZ(e,fi.x,fi.y,fi.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)fi.fromBufferAttribute(this,e),fi.applyNormalMatrix(t),this.setXYZ(e,fi.x,fi.y,fi.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)fi.fromBufferAttribute(this,e),fi.transformDirection(t),this.setXYZ(e,fi.x,fi.y,fi.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):CM(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):PM(t,this.array)}};var da=class extends si{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var fa=class extends si{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var yn=class extends si{constructor(t,e,i){super(new Float32Array(t),e,i)}},HM=new ks,na=new J,gd=new J,hr=class{constructor(t=new J,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):HM.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;na.subVectors(t,this.center);let e=na.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(na,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(gd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(na.copy(t.center).add(gd)),this.expandByPoint(na.copy(t.center).sub(gd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},GM=0,xn=new Ue,_d=new hn,ao=new J,an=new ks,sa=new ks,Ri=new J,mi=class n extends Yn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:GM++}),this.uuid=Ia(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(TM(t)?fa:da)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Qt().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return xn.makeRotationFromQuaternion(t),this.applyMatrix4(xn),this}rotateX(t){return xn.makeRotationX(t),this.applyMatrix4(xn),this}rotateY(t){return xn.makeRotationY(t),this.applyMatrix4(xn),this}rotateZ(t){return xn.makeRotationZ(t),this.applyMatrix4(xn),this}translate(t,e,i){return xn.makeTranslation(t,e,i),this.applyMatrix4(xn),this}scale(t,e,i){return xn.makeScale(t,e,i),this.applyMatrix4(xn),this}lookAt(t){return _d.lookAt(t),_d.updateMatrix(),this.applyMatrix4(_d.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ao).negate(),this.translate(ao.x,ao.y,ao.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new yn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Yt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ks);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new J(-1/0,-1/0,-1/0),new J(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];an.setFromBufferAttribute(r),this.morphTargetsRelative?(Ri.addVectors(this.boundingBox.min,an.min),this.boundingBox.expandByPoint(Ri),Ri.addVectors(this.boundingBox.max,an.max),this.boundingBox.expandByPoint(Ri)):(this.boundingBox.expandByPoint(an.min),this.boundingBox.expandByPoint(an.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&jt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new hr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new J,1/0);return}if(t){let i=this.boundingSphere.center;if(an.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];sa.setFromBufferAttribute(a),this.morphTargetsRelative?(Ri.addVectors(an.min,sa.min),an.expandByPoint(Ri),Ri.addVectors(an.max,sa.max),an.expandByPoint(Ri)):(an.expandByPoint(sa.min),an.expandByPoint(sa.max))}an.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Ri.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Ri));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Ri.fromBufferAttribute(a,c),l&&(ao.fromBufferAttribute(t,c),Ri.add(ao)),s=Math.max(s,i.distanceToSquared(Ri))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&jt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){jt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new si(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let k=0;k<i.count;k++)a[k]=new J,l[k]=new J;let h=new J,d=new J,u=new J,f=new ge,m=new ge,v=new ge,g=new J,p=new J;function y(k,N,I){c[k]=c[N]=c[I]=1,h.fromBufferAttribute(i,k),d.fromBufferAttribute(i,N),u.fromBufferAttribute(i,I),f.fromBufferAttribute(r,k),m.fromBufferAttribute(r,N),v.fromBufferAttribute(r,I),d.sub(h),u.sub(h),m.sub(f),v.sub(f);let V=1/(m.x*v.y-v.x*m.y);isFinite(V)&&(g.copy(d).multiplyScalar(v.y).addScaledVector(u,-m.y).multiplyScalar(V),p.copy(u).multiplyScalar(m.x).addScaledVector(d,-v.x).multiplyScalar(V),a[k].add(g),a[N].add(g),a[I].add(g),l[k].add(p),l[N].add(p),l[I].add(p))}let T=this.groups;T.length===0&&(T=[{start:0,count:t.count}]);for(let k=0,N=T.length;k<N;++k){let I=T[k],V=I.start,G=I.count;for(let D=V,H=V+G;D<H;D+=3)y(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let M=new J,R=new J,A=new J,_=new J;function E(k){A.fromBufferAttribute(s,k),_.copy(A);let N=a[k];M.copy(N),M.sub(A.multiplyScalar(A.dot(N))).normalize(),R.crossVectors(_,N);let V=R.dot(l[k])<0?-1:1;o.setXYZW(k,M.x,M.y,M.z,V)}for(let k=0,N=i.count;k<N;++k)c[k]&&E(k);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new si(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let u=0,f=i.count;u<f;u++)i.setXYZ(u,0,0,0);let s=new J,r=new J,o=new J,a=new J,l=new J,c=new J,h=new J,d=new J;if(t)for(let u=0,f=t.count;u<f;u+=3){let m=t.getX(u+0),v=t.getX(u+1),g=t.getX(u+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,g),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,g),a.add(h),l.add(h),c.add(h),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let u=0,f=e.count;u<f;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Ri.fromBufferAttribute(t,e),Ri.normalize(),t.setXYZ(e,Ri.x,Ri.y,Ri.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),f=0,m=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*h;for(let p=0;p<h;p++)u[m++]=c[f++]}return new si(u,h,d)}if(this.index===null)return Yt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],f=t(u,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let f=c[d];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var xd=new J,WM=new J,XM=new Qt,Nn=class{constructor(t=new J(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=xd.subVectors(i,e).cross(WM.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(xd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||XM.getNormalMatrix(t),s=this.coplanarPoint(xd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},$M=0,Bs=class extends Yn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:$M++}),this.uuid=Ia(),this.name="",this.type="Material",this.blending=Mo,this.side=Gs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ld,this.blendDst=Nd,this.blendEquation=pr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new _e(0,0,0),this.blendAlpha=0,this.depthFunc=fo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=t0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=fc,this.stencilZFail=fc,this.stencilZPass=fc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Yt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Yt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new _e().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new Nn().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new ge().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ge().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var fs=new J,vd=new J,Jl=new J,jl=new J,pa=class{constructor(t=new J,e=new J(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,fs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=fs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(fs.copy(this.origin).addScaledVector(this.direction,e),fs.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){vd.copy(t).add(e).multiplyScalar(.5),Jl.copy(e).sub(t).normalize(),jl.copy(this.origin).sub(vd);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Jl),a=jl.dot(this.direction),l=-jl.dot(Jl),c=jl.lengthSq(),h=Math.abs(1-o*o),d,u,f,m;if(h>0)if(d=o*l-a,u=o*a-l,m=r*h,d>=0)if(u>=-m)if(u<=m){let v=1/h;d*=v,u*=v,f=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u<=-m?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c):u<=m?(d=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(vd).addScaledVector(Jl,u),f}intersectSphere(t,e){if(t.radius<0)return null;fs.subVectors(t.center,this.origin);let i=fs.dot(this.direction),s=fs.dot(fs)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(i=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(i=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-u.z)*d,l=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,l=(t.min.z-u.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,fs)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=t.x-o.x,u=t.y-o.y,f=t.z-o.z,m=e.x-o.x,v=e.y-o.y,g=e.z-o.z,p=i.x-o.x,y=i.y-o.y,T=i.z-o.z,M=Math.abs(l),R=Math.abs(c),A=Math.abs(h),_,E,k,N,I,V,G,D,H,Z,z,ct;if(M>=R&&M>=A?(k=l,V=d,H=m,ct=p,l>=0?(_=c,E=h,N=u,I=f,G=v,D=g,Z=y,z=T):(_=h,E=c,N=f,I=u,G=g,D=v,Z=T,z=y)):R>=A?(k=c,V=u,H=v,ct=y,c>=0?(_=h,E=l,N=f,I=d,G=g,D=m,Z=T,z=p):(_=l,E=h,N=d,I=f,G=m,D=g,Z=p,z=T)):(k=h,V=f,H=g,ct=T,h>=0?(_=l,E=c,N=d,I=u,G=m,D=v,Z=p,z=y):(_=c,E=l,N=u,I=d,G=v,D=m,Z=y,z=p)),k===0)return null;let K=_/k,Q=E/k,st=1/k,dt=N-K*V,ut=I-Q*V,tt=G-K*H,mt=D-Q*H,xt=Z-K*ct,At=z-Q*ct,St=xt*mt-At*tt,Gt=dt*At-ut*xt,ie=tt*ut-mt*dt;if(s){if(St<0||Gt<0||ie<0)return null}else if((St<0||Gt<0||ie<0)&&(St>0||Gt>0||ie>0))return null;let Vt=St+Gt+ie;if(Vt===0)return null;let le=st*(St*V+Gt*H+ie*ct);return(Vt>0?le<0:le>0)?null:this.at(le/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Rc=class extends Bs{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new _e(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Os,this.combine=Dd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},yg=new Ue,or=new pa,Ql=new hr,Mg=new J,tc=new J,ec=new J,ic=new J,yd=new J,nc=new J,Sg=new J,sc=new J,yi=class extends hn{constructor(t=new mi,e=new Rc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){nc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&(yd.fromBufferAttribute(d,t),o?nc.addScaledVector(yd,h):nc.addScaledVector(yd.sub(e),h))}e.add(nc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Ql.copy(i.boundingSphere),Ql.applyMatrix4(r),or.copy(t.ray).recast(t.near),!(Ql.containsPoint(or.origin)===!1&&(or.intersectSphere(Ql,Mg)===null||or.origin.distanceToSquared(Mg)>(t.far-t.near)**2))&&(yg.copy(r).invert(),or.copy(t.ray).applyMatrix4(yg),!(i.boundingBox!==null&&or.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,or)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,v=u.length;m<v;m++){let g=u[m],p=o[g.materialIndex],y=Math.max(g.start,f.start),T=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let M=y,R=T;M<R;M+=3){let A=a.getX(M),_=a.getX(M+1),E=a.getX(M+2);s=rc(this,p,t,i,c,h,d,A,_,E),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let g=m,p=v;g<p;g+=3){let y=a.getX(g),T=a.getX(g+1),M=a.getX(g+2);s=rc(this,o,t,i,c,h,d,y,T,M),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,v=u.length;m<v;m++){let g=u[m],p=o[g.materialIndex],y=Math.max(g.start,f.start),T=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let M=y,R=T;M<R;M+=3){let A=M,_=M+1,E=M+2;s=rc(this,p,t,i,c,h,d,A,_,E),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let g=m,p=v;g<p;g+=3){let y=g,T=g+1,M=g+2;s=rc(this,o,t,i,c,h,d,y,T,M),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function qM(n,t,e,i,s,r,o,a){let l;if(t.side===Xi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Gs,a),l===null)return null;sc.copy(a),sc.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(sc);return c<e.near||c>e.far?null:{distance:c,point:sc.clone(),object:n}}function rc(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,tc),n.getVertexPosition(l,ec),n.getVertexPosition(c,ic);let h=qM(n,t,e,i,tc,ec,ic,Sg);if(h){let d=new J;Fs.getBarycoord(Sg,tc,ec,ic,d),s&&(h.uv=Fs.getInterpolatedAttribute(s,a,l,c,d,new ge)),r&&(h.uv1=Fs.getInterpolatedAttribute(r,a,l,c,d,new ge)),o&&(h.normal=Fs.getInterpolatedAttribute(o,a,l,c,d,new J),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new J,materialIndex:0};Fs.getNormal(tc,ec,ic,u.normal),h.face=u,h.barycoord=d}return h}var gs=class extends Ji{constructor(t=null,e=1,i=1,s,r,o,a,l,c=pi,h=pi,d,u){super(null,o,a,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ar=new hr,YM=new ge(.5,.5),oc=new J,ur=class{constructor(t=new Nn,e=new Nn,i=new Nn,s=new Nn,r=new Nn,o=new Nn){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=vn,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],f=r[7],m=r[8],v=r[9],g=r[10],p=r[11],y=r[12],T=r[13],M=r[14],R=r[15];if(s[0].setComponents(c-o,f-h,p-m,R-y).normalize(),s[1].setComponents(c+o,f+h,p+m,R+y).normalize(),s[2].setComponents(c+a,f+d,p+v,R+T).normalize(),s[3].setComponents(c-a,f-d,p-v,R-T).normalize(),i)s[4].setComponents(l,u,g,M).normalize(),s[5].setComponents(c-l,f-u,p-g,R-M).normalize();else if(s[4].setComponents(c-l,f-u,p-g,R-M).normalize(),e===vn)s[5].setComponents(c+l,f+u,p+g,R+M).normalize();else if(e===la)s[5].setComponents(l,u,g,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),ar.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),ar.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(ar)}intersectsSprite(t){ar.center.set(0,0,0);let e=YM.distanceTo(t.center);return ar.radius=.7071067811865476+e,ar.applyMatrix4(t.matrixWorld),this.intersectsSphere(ar)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(oc.x=s.normal.x>0?t.max.x:t.min.x,oc.y=s.normal.y>0?t.max.y:t.min.y,oc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(oc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},bg=new Ue,Cc=class n{constructor(){this.coordinateSystem=vn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];bg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new ur),i[s].setFromProjectionMatrix(bg,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new ur),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Pc=class extends Bs{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new _e(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},wg=new Ue,Ed=new pa,ac=new hr,lc=new J,dr=class extends hn{constructor(t=new mi,e=new Pc){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ac.copy(i.boundingSphere),ac.applyMatrix4(s),ac.radius+=r,t.ray.intersectsSphere(ac)===!1)return;wg.copy(s).invert(),Ed.copy(t.ray).applyMatrix4(wg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,d=i.attributes.position;if(c!==null){let u=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let m=u,v=f;m<v;m++){let g=c.getX(m);lc.fromBufferAttribute(d,g),Eg(lc,g,l,s,t,e,this)}}else{let u=Math.max(0,o.start),f=Math.min(d.count,o.start+o.count);for(let m=u,v=f;m<v;m++)lc.fromBufferAttribute(d,m),Eg(lc,m,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Eg(n,t,e,i,s,r,o){let a=Ed.distanceSqToPoint(n);if(a<e){let l=new J;Ed.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var ma=class extends Ji{constructor(t=[],e=mr,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var _s=class extends Ji{constructor(t,e,i=Dn,s,r,o,a=pi,l=pi,c,h=ms,d=1){if(h!==ms&&h!==ys)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:d};super(u,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new mo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ga=class extends _s{constructor(t,e=Dn,i=mr,s,r,o=pi,a=pi,l,c=ms){let h={width:t,height:t,depth:1},d=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},_a=class extends Ji{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},_o=class n extends mi{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,f=0;m("z","y","x",-1,-1,i,e,t,o,r,0),m("z","y","x",1,-1,i,e,-t,o,r,1),m("x","z","y",1,1,t,i,e,s,o,2),m("x","z","y",1,-1,t,i,-e,s,o,3),m("x","y","z",1,-1,t,e,i,s,r,4),m("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new yn(c,3)),this.setAttribute("normal",new yn(h,3)),this.setAttribute("uv",new yn(d,2));function m(v,g,p,y,T,M,R,A,_,E,k){let N=M/_,I=R/E,V=M/2,G=R/2,D=A/2,H=_+1,Z=E+1,z=0,ct=0,K=new J;for(let Q=0;Q<Z;Q++){let st=Q*I-G;for(let dt=0;dt<H;dt++){let ut=dt*N-V;K[v]=ut*y,K[g]=st*T,K[p]=D,c.push(K.x,K.y,K.z),K[v]=0,K[g]=0,K[p]=A>0?1:-1,h.push(K.x,K.y,K.z),d.push(dt/_),d.push(1-Q/E),z+=1}}for(let Q=0;Q<E;Q++)for(let st=0;st<_;st++){let dt=u+st+H*Q,ut=u+st+H*(Q+1),tt=u+(st+1)+H*(Q+1),mt=u+(st+1)+H*Q;l.push(dt,ut,mt),l.push(ut,tt,mt),ct+=6}a.addGroup(f,ct,k),f+=ct,u+=z}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var xa=class n extends mi{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,d=t/a,u=e/l,f=[],m=[],v=[],g=[];for(let p=0;p<h;p++){let y=p*u-o;for(let T=0;T<c;T++){let M=T*d-r;m.push(M,-y,0),v.push(0,0,1),g.push(T/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){let T=y+c*p,M=y+c*(p+1),R=y+1+c*(p+1),A=y+1+c*p;f.push(T,M,A),f.push(M,R,A)}this.setIndex(f),this.setAttribute("position",new yn(m,3)),this.setAttribute("normal",new yn(v,3)),this.setAttribute("uv",new yn(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};function _r(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Tg(s))s.isRenderTargetTexture?(Yt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Tg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Oi(n){let t={};for(let e=0;e<n.length;e++){let i=_r(n[e]);for(let s in i)t[s]=i[s]}return t}function Tg(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function ZM(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function nf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:me.workingColorSpace}var f0={clone:_r,merge:Oi},KM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,JM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Kn=class extends Bs{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=KM,this.fragmentShader=JM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=_r(t.uniforms),this.uniformsGroups=ZM(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new _e().setHex(s.value);break;case"v2":this.uniforms[i].value=new ge().fromArray(s.value);break;case"v3":this.uniforms[i].value=new J().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Ze().fromArray(s.value);break;case"m3":this.uniforms[i].value=new Qt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Ue().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},xo=class extends Kn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ic=class extends Bs{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=jg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Lc=class extends Bs{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function lo(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function cc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var zs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];i:{t:{let o;e:{n:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break n;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break i}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Nc=class extends zs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Sd,endingEnd:Sd}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case bd:r=t,a=2*e-i;break;case wd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case bd:o=t,l=2*i-e;break;case wd:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,m=(i-e)/(s-e),v=m*m,g=v*m,p=-u*g+2*u*v-u*m,y=(1+u)*g+(-1.5-2*u)*v+(-.5+u)*m+1,T=(-1-f)*g+(1.5+f)*v+.5*m,M=f*g-f*v;for(let R=0;R!==a;++R)r[R]=p*o[h+R]+y*o[c+R]+T*o[l+R]+M*o[d+R];return r}},Dc=class extends zs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),d=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*h;return r}},Fc=class extends zs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Uc=class extends zs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let m=(i-e)/(s-e),v=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*v+o[l+g]*m;return r}let u=a*2,f=t-1;for(let m=0;m!==a;++m){let v=o[c+m],g=o[l+m],p=f*u+m*2,y=d[p],T=d[p+1],M=t*u+m*2,R=h[M],A=h[M+1],_=QM(i,e,y,R,s);r[m]=p0(_,v,T,A,g)}return r}};function p0(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function jM(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function QM(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=p0(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=jM(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var un=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=lo(e,this.TimeBufferType),this.values=lo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:lo(t.times,Array),values:lo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),cc(t.settings)&&(i.settings={inTangents:lo(t.settings.inTangents,Array),outTangents:lo(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Fc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Dc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Nc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Uc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case oa:e=this.InterpolantFactoryMethodDiscrete;break;case bc:e=this.InterpolantFactoryMethodLinear;break;case dc:e=this.InterpolantFactoryMethodSmooth;break;case Md:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Yt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return oa;case this.InterpolantFactoryMethodLinear:return bc;case this.InterpolantFactoryMethodSmooth:return dc;case this.InterpolantFactoryMethodBezier:return Md}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;cc(this.settings)&&(Ag(this.settings.inTangents,t),Ag(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;cc(this.settings)&&(Rg(this.settings.inTangents,t),Rg(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(jt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(jt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){jt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){jt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&AM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){jt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===dc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*i,u=d-i,f=d+i;for(let m=0;m!==i;++m){let v=e[d+m];if(v!==e[u+m]||v!==e[f+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*i,u=o*i;for(let f=0;f!==i;++f)e[u+f]=e[d+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,cc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Ag(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Rg(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}un.prototype.ValueTypeName="";un.prototype.TimeBufferType=Float32Array;un.prototype.ValueBufferType=Float32Array;un.prototype.DefaultInterpolation=bc;var Vs=class extends un{constructor(t,e,i){super(t,e,i)}};Vs.prototype.ValueTypeName="bool";Vs.prototype.ValueBufferType=Array;Vs.prototype.DefaultInterpolation=oa;Vs.prototype.InterpolantFactoryMethodLinear=void 0;Vs.prototype.InterpolantFactoryMethodSmooth=void 0;var Oc=class extends un{constructor(t,e,i,s){super(t,e,i,s)}};Oc.prototype.ValueTypeName="color";var kc=class extends un{constructor(t,e,i,s){super(t,e,i,s)}};kc.prototype.ValueTypeName="number";var Bc=class extends zs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Zn.slerpFlat(r,0,o,c-a,o,c,l);return r}},va=class extends un{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Bc(this.times,this.values,this.getValueSize(),t)}};va.prototype.ValueTypeName="quaternion";va.prototype.InterpolantFactoryMethodSmooth=void 0;var Hs=class extends un{constructor(t,e,i){super(t,e,i)}};Hs.prototype.ValueTypeName="string";Hs.prototype.ValueBufferType=Array;Hs.prototype.DefaultInterpolation=oa;Hs.prototype.InterpolantFactoryMethodLinear=void 0;Hs.prototype.InterpolantFactoryMethodSmooth=void 0;var zc=class extends un{constructor(t,e,i,s){super(t,e,i,s)}};zc.prototype.ValueTypeName="vector";var Vc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let f=c[d],m=c[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},m0=new Vc,Hc=class{constructor(t){this.manager=t!==void 0?t:m0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Hc.DEFAULT_MATERIAL_NAME="__DEFAULT";var hc=new J,uc=new Zn,$n=new J,fr=class extends hn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ue,this.projectionMatrix=new Ue,this.projectionMatrixInverse=new Ue,this.coordinateSystem=vn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(hc,uc,$n),$n.x===1&&$n.y===1&&$n.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(hc,uc,$n.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(hc,uc,$n),$n.x===1&&$n.y===1&&$n.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(hc,uc,$n.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ds=new J,Cg=new ge,Pg=new ge,cn=class extends fr{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=wc*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(td*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return wc*2*Math.atan(Math.tan(td*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Ds.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ds.x,Ds.y).multiplyScalar(-t/Ds.z),Ds.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ds.x,Ds.y).multiplyScalar(-t/Ds.z)}getViewSize(t,e){return this.getViewBounds(t,Cg,Pg),e.subVectors(Pg,Cg)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(td*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Gc=class extends fr{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var co=-90,ho=1,vo=class extends hn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new cn(co,ho,t,e);s.layers=this.layers,this.add(s);let r=new cn(co,ho,t,e);r.layers=this.layers,this.add(r);let o=new cn(co,ho,t,e);o.layers=this.layers,this.add(o);let a=new cn(co,ho,t,e);a.layers=this.layers,this.add(a);let l=new cn(co,ho,t,e);l.layers=this.layers,this.add(l);let c=new cn(co,ho,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===vn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===la)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=v,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(d,u,f),t.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},Wc=class extends cn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var sf="\\[\\]\\.:\\/",tS=new RegExp("["+sf+"]","g"),rf="[^"+sf+"]",eS="[^"+sf.replace("\\.","")+"]",iS=/((?:WC+[\/:])*)/.source.replace("WC",rf),nS=/(WCOD+)?/.source.replace("WCOD",eS),sS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",rf),rS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",rf),oS=new RegExp("^"+iS+nS+sS+rS+"$"),aS=["material","materials","bones","map"],Td=class{constructor(t,e,i){let s=i||Ge.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Ge=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(tS,"")}static parseTrackName(t){let e=oS.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);aS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Yt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){jt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){jt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){jt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){jt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){jt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;jt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ge.Composite=Td;Ge.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ge.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ge.prototype.GetterByBindingType=[Ge.prototype._getValue_direct,Ge.prototype._getValue_array,Ge.prototype._getValue_arrayElement,Ge.prototype._getValue_toArray];Ge.prototype.SetterByBindingTypeAndVersioning=[[Ge.prototype._setValue_direct,Ge.prototype._setValue_direct_setNeedsUpdate,Ge.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_array,Ge.prototype._setValue_array_setNeedsUpdate,Ge.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_arrayElement,Ge.prototype._setValue_arrayElement_setNeedsUpdate,Ge.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_fromArray,Ge.prototype._setValue_fromArray_setNeedsUpdate,Ge.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var GC=new Float32Array(1);var Ad=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};function of(n,t,e,i){let s=lS(i);switch(e){case qd:return n*t;case Zd:return n*t/s.components*s.byteLength;case Qc:return n*t/s.components*s.byteLength;case Ws:return n*t*2/s.components*s.byteLength;case th:return n*t*2/s.components*s.byteLength;case Yd:return n*t*3/s.components*s.byteLength;case qi:return n*t*4/s.components*s.byteLength;case eh:return n*t*4/s.components*s.byteLength;case ba:case wa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ea:case Ta:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case nh:case rh:return Math.max(n,16)*Math.max(t,8)/4;case ih:case sh:return Math.max(n,8)*Math.max(t,8)/2;case oh:case ah:case ch:case hh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case lh:case Aa:case uh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case dh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case fh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case ph:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case mh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case gh:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case _h:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case xh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case vh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case yh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Mh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Sh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case bh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case wh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Eh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Th:case Ah:case Rh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Ch:case Ph:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Ra:case Ih:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function lS(n){switch(n){case dn:case Gd:return{byteLength:1,components:1};case bo:case Wd:case Fn:return{byteLength:2,components:1};case Jc:case jc:return{byteLength:2,components:4};case Dn:case Kc:case $i:return{byteLength:4,components:1};case Xd:case $d:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Yt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function O0(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function hS(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=n.createBuffer();n.bindBuffer(l,u),n.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let h=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,h);else{d.sort((f,m)=>f.start-m.start);let u=0;for(let f=1;f<d.length;f++){let m=d[u],v=d[f];v.start<=m.start+m.count+1?m.count=Math.max(m.count,v.start+v.count-m.start):(++u,d[u]=v)}d.length=u+1;for(let f=0,m=d.length;f<m;f++){let v=d[f];n.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var uS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,dS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,fS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,pS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,mS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,gS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,_S=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,xS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,vS=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,yS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,MS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,SS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,bS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,wS=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,ES=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,TS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,AS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,RS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,CS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,PS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,IS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,LS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,NS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,DS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,FS=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,US=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,OS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,kS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,BS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,zS="gl_FragColor = linearToOutputTexel( gl_FragColor );",VS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,HS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,GS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,WS=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,XS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,$S=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,qS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,YS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ZS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,KS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,JS=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,jS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,QS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,tb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,eb=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,ib=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,nb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,sb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,rb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,ob=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,ab=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,lb=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,cb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,hb=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,ub=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,db=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,fb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,pb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,mb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,gb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,_b=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,xb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,vb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,yb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Mb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Sb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,bb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,wb=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Eb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Tb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Ab=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Rb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Cb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Pb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ib=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Lb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Nb=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Db=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Fb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Ub=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Ob=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,kb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Bb=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,zb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Vb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Hb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Gb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Wb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Xb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,$b=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,qb=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Yb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Zb=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Kb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Jb=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,jb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Qb=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,tw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ew=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,iw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,nw=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,sw=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,rw=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,ow=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,aw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,lw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,cw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,hw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,uw=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,dw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,fw=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,pw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,mw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,gw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,_w=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,xw=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,vw=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,yw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Mw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Sw=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,bw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,ww=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Ew=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Tw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Aw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Rw=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Cw=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Pw=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Iw=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Lw=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Nw=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Dw=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Fw=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Uw=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Ow=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kw=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Bw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,zw=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Vw=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Hw=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Gw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ae={alphahash_fragment:uS,alphahash_pars_fragment:dS,alphamap_fragment:fS,alphamap_pars_fragment:pS,alphatest_fragment:mS,alphatest_pars_fragment:gS,aomap_fragment:_S,aomap_pars_fragment:xS,batching_pars_vertex:vS,batching_vertex:yS,begin_vertex:MS,beginnormal_vertex:SS,bsdfs:bS,iridescence_fragment:wS,bumpmap_pars_fragment:ES,clipping_planes_fragment:TS,clipping_planes_pars_fragment:AS,clipping_planes_pars_vertex:RS,clipping_planes_vertex:CS,color_fragment:PS,color_pars_fragment:IS,color_pars_vertex:LS,color_vertex:NS,common:DS,defaultnormal_vertex:FS,displacementmap_pars_vertex:US,displacementmap_vertex:OS,emissivemap_fragment:kS,emissivemap_pars_fragment:BS,colorspace_fragment:zS,colorspace_pars_fragment:VS,envmap_fragment:HS,envmap_common_pars_fragment:GS,envmap_pars_fragment:WS,envmap_pars_vertex:XS,envmap_physical_pars_fragment:ib,envmap_vertex:$S,fog_vertex:qS,fog_pars_vertex:YS,fog_fragment:ZS,fog_pars_fragment:KS,gradientmap_pars_fragment:JS,lightmap_pars_fragment:jS,lights_lambert_fragment:QS,lights_lambert_pars_fragment:tb,lights_pars_begin:eb,lights_toon_fragment:nb,lights_toon_pars_fragment:sb,lights_phong_fragment:rb,lights_phong_pars_fragment:ob,lights_physical_fragment:ab,lights_physical_pars_fragment:lb,lights_fragment_begin:cb,lights_fragment_maps:hb,lights_fragment_end:ub,lightprobes_pars_fragment:db,logdepthbuf_fragment:fb,logdepthbuf_pars_fragment:pb,logdepthbuf_pars_vertex:mb,logdepthbuf_vertex:gb,map_fragment:_b,map_pars_fragment:xb,map_particle_fragment:vb,map_particle_pars_fragment:yb,metalnessmap_fragment:Mb,metalnessmap_pars_fragment:Sb,morphinstance_vertex:bb,morphcolor_vertex:wb,morphnormal_vertex:Eb,morphtarget_pars_vertex:Tb,morphtarget_vertex:Ab,normal_fragment_begin:Rb,normal_fragment_maps:Cb,normal_pars_fragment:Pb,normal_pars_vertex:Ib,normal_vertex:Lb,normalmap_pars_fragment:Nb,clearcoat_normal_fragment_begin:Db,clearcoat_normal_fragment_maps:Fb,clearcoat_pars_fragment:Ub,iridescence_pars_fragment:Ob,opaque_fragment:kb,packing:Bb,premultiplied_alpha_fragment:zb,project_vertex:Vb,dithering_fragment:Hb,dithering_pars_fragment:Gb,roughnessmap_fragment:Wb,roughnessmap_pars_fragment:Xb,shadowmap_pars_fragment:$b,shadowmap_pars_vertex:qb,shadowmap_vertex:Yb,shadowmask_pars_fragment:Zb,skinbase_vertex:Kb,skinning_pars_vertex:Jb,skinning_vertex:jb,skinnormal_vertex:Qb,specularmap_fragment:tw,specularmap_pars_fragment:ew,tonemapping_fragment:iw,tonemapping_pars_fragment:nw,transmission_fragment:sw,transmission_pars_fragment:rw,uv_pars_fragment:ow,uv_pars_vertex:aw,uv_vertex:lw,worldpos_vertex:cw,background_vert:hw,background_frag:uw,backgroundCube_vert:dw,backgroundCube_frag:fw,cube_vert:pw,cube_frag:mw,depth_vert:gw,depth_frag:_w,distance_vert:xw,distance_frag:vw,equirect_vert:yw,equirect_frag:Mw,linedashed_vert:Sw,linedashed_frag:bw,meshbasic_vert:ww,meshbasic_frag:Ew,meshlambert_vert:Tw,meshlambert_frag:Aw,meshmatcap_vert:Rw,meshmatcap_frag:Cw,meshnormal_vert:Pw,meshnormal_frag:Iw,meshphong_vert:Lw,meshphong_frag:Nw,meshphysical_vert:Dw,meshphysical_frag:Fw,meshtoon_vert:Uw,meshtoon_frag:Ow,points_vert:kw,points_frag:Bw,shadow_vert:zw,shadow_frag:Vw,sprite_vert:Hw,sprite_frag:Gw},Lt={common:{diffuse:{value:new _e(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Qt},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Qt}},envmap:{envMap:{value:null},envMapRotation:{value:new Qt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Qt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Qt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Qt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Qt},normalScale:{value:new ge(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Qt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Qt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Qt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Qt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new _e(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new _e(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0},uvTransform:{value:new Qt}},sprite:{diffuse:{value:new _e(16777215)},opacity:{value:1},center:{value:new ge(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Qt},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0}}},Qn={basic:{uniforms:Oi([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:ae.meshbasic_vert,fragmentShader:ae.meshbasic_frag},lambert:{uniforms:Oi([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new _e(0)},envMapIntensity:{value:1}}]),vertexShader:ae.meshlambert_vert,fragmentShader:ae.meshlambert_frag},phong:{uniforms:Oi([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new _e(0)},specular:{value:new _e(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ae.meshphong_vert,fragmentShader:ae.meshphong_frag},standard:{uniforms:Oi([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new _e(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ae.meshphysical_vert,fragmentShader:ae.meshphysical_frag},toon:{uniforms:Oi([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new _e(0)}}]),vertexShader:ae.meshtoon_vert,fragmentShader:ae.meshtoon_frag},matcap:{uniforms:Oi([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:ae.meshmatcap_vert,fragmentShader:ae.meshmatcap_frag},points:{uniforms:Oi([Lt.points,Lt.fog]),vertexShader:ae.points_vert,fragmentShader:ae.points_frag},dashed:{uniforms:Oi([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ae.linedashed_vert,fragmentShader:ae.linedashed_frag},depth:{uniforms:Oi([Lt.common,Lt.displacementmap]),vertexShader:ae.depth_vert,fragmentShader:ae.depth_frag},normal:{uniforms:Oi([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:ae.meshnormal_vert,fragmentShader:ae.meshnormal_frag},sprite:{uniforms:Oi([Lt.sprite,Lt.fog]),vertexShader:ae.sprite_vert,fragmentShader:ae.sprite_frag},background:{uniforms:{uvTransform:{value:new Qt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ae.background_vert,fragmentShader:ae.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Qt}},vertexShader:ae.backgroundCube_vert,fragmentShader:ae.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ae.cube_vert,fragmentShader:ae.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ae.equirect_vert,fragmentShader:ae.equirect_frag},distance:{uniforms:Oi([Lt.common,Lt.displacementmap,{referencePosition:{value:new J},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ae.distance_vert,fragmentShader:ae.distance_frag},shadow:{uniforms:Oi([Lt.lights,Lt.fog,{color:{value:new _e(0)},opacity:{value:1}}]),vertexShader:ae.shadow_vert,fragmentShader:ae.shadow_frag}};Qn.physical={uniforms:Oi([Qn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Qt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Qt},clearcoatNormalScale:{value:new ge(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Qt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Qt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Qt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Qt},sheen:{value:0},sheenColor:{value:new _e(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Qt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Qt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Qt},transmissionSamplerSize:{value:new ge},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Qt},attenuationDistance:{value:0},attenuationColor:{value:new _e(0)},specularColor:{value:new _e(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Qt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Qt},anisotropyVector:{value:new ge},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Qt}}]),vertexShader:ae.meshphysical_vert,fragmentShader:ae.meshphysical_frag};var Lh={r:0,b:0,g:0},Ww=new Ue,k0=new Qt;k0.set(-1,0,0,0,1,0,0,0,1);function Xw(n,t,e,i,s,r){let o=new _e(0),a=s===!0?0:1,l,c,h=null,d=0,u=null;function f(y){let T=y.isScene===!0?y.background:null;if(T&&T.isTexture){let M=y.backgroundBlurriness>0;T=t.get(T,M)}return T}function m(y){let T=!1,M=f(y);M===null?g(o,a):M&&M.isColor&&(g(M,1),T=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||T)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(y,T){let M=f(T);M&&M.isCubeTexture?(c===void 0&&(c=new yi(new _o(1,1,1),new Kn({name:"BackgroundCubeMaterial",uniforms:_r(Qn.backgroundCube.uniforms),vertexShader:Qn.backgroundCube.vertexShader,fragmentShader:Qn.backgroundCube.fragmentShader,side:Xi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Ww.makeRotationFromEuler(T.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(k0),c.material.toneMapped=me.getTransfer(M.colorSpace)!==Ee,(h!==M||d!==M.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=M,d=M.version,u=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new yi(new xa(2,2),new Kn({name:"BackgroundMaterial",uniforms:_r(Qn.background.uniforms),vertexShader:Qn.background.vertexShader,fragmentShader:Qn.background.fragmentShader,side:Gs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=me.getTransfer(M.colorSpace)!==Ee,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||d!==M.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=M,d=M.version,u=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function g(y,T){y.getRGB(Lh,nf(n)),e.buffers.color.setClear(Lh.r,Lh.g,Lh.b,T,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,T=1){o.set(y),a=T,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:m,addToRenderList:v,dispose:p}}function $w(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=u(null),r=s,o=!1;function a(I,V,G,D,H){let Z=!1,z=d(I,D,G,V);r!==z&&(r=z,c(r.object)),Z=f(I,D,G,H),Z&&m(I,D,G,H),H!==null&&t.update(H,n.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,M(I,V,G,D),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(H).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function h(I){return n.deleteVertexArray(I)}function d(I,V,G,D){let H=D.wireframe===!0,Z=i[V.id];Z===void 0&&(Z={},i[V.id]=Z);let z=I.isInstancedMesh===!0?I.id:0,ct=Z[z];ct===void 0&&(ct={},Z[z]=ct);let K=ct[G.id];K===void 0&&(K={},ct[G.id]=K);let Q=K[H];return Q===void 0&&(Q=u(l()),K[H]=Q),Q}function u(I){let V=[],G=[],D=[];for(let H=0;H<e;H++)V[H]=0,G[H]=0,D[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:V,enabledAttributes:G,attributeDivisors:D,object:I,attributes:{},index:null}}function f(I,V,G,D){let H=r.attributes,Z=V.attributes,z=0,ct=G.getAttributes();for(let K in ct)if(ct[K].location>=0){let st=H[K],dt=Z[K];if(dt===void 0&&(K==="instanceMatrix"&&I.instanceMatrix&&(dt=I.instanceMatrix),K==="instanceColor"&&I.instanceColor&&(dt=I.instanceColor)),st===void 0||st.attribute!==dt||dt&&st.data!==dt.data)return!0;z++}return r.attributesNum!==z||r.index!==D}function m(I,V,G,D){let H={},Z=V.attributes,z=0,ct=G.getAttributes();for(let K in ct)if(ct[K].location>=0){let st=Z[K];st===void 0&&(K==="instanceMatrix"&&I.instanceMatrix&&(st=I.instanceMatrix),K==="instanceColor"&&I.instanceColor&&(st=I.instanceColor));let dt={};dt.attribute=st,st&&st.data&&(dt.data=st.data),H[K]=dt,z++}r.attributes=H,r.attributesNum=z,r.index=D}function v(){let I=r.newAttributes;for(let V=0,G=I.length;V<G;V++)I[V]=0}function g(I){p(I,0)}function p(I,V){let G=r.newAttributes,D=r.enabledAttributes,H=r.attributeDivisors;G[I]=1,D[I]===0&&(n.enableVertexAttribArray(I),D[I]=1),H[I]!==V&&(n.vertexAttribDivisor(I,V),H[I]=V)}function y(){let I=r.newAttributes,V=r.enabledAttributes;for(let G=0,D=V.length;G<D;G++)V[G]!==I[G]&&(n.disableVertexAttribArray(G),V[G]=0)}function T(I,V,G,D,H,Z,z){z===!0?n.vertexAttribIPointer(I,V,G,H,Z):n.vertexAttribPointer(I,V,G,D,H,Z)}function M(I,V,G,D){v();let H=D.attributes,Z=G.getAttributes(),z=V.defaultAttributeValues;for(let ct in Z){let K=Z[ct];if(K.location>=0){let Q=H[ct];if(Q===void 0&&(ct==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),ct==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let st=Q.normalized,dt=Q.itemSize,ut=t.get(Q);if(ut===void 0)continue;let tt=ut.buffer,mt=ut.type,xt=ut.bytesPerElement,At=mt===n.INT||mt===n.UNSIGNED_INT||Q.gpuType===Kc;if(Q.isInterleavedBufferAttribute){let St=Q.data,Gt=St.isInterleavedBuffer===!0?St.stride:St.itemSize,ie=Q.offset;if(St.isInstancedInterleavedBuffer||St.isInstancedBufferAttribute){for(let Vt=0;Vt<K.locationSize;Vt++)p(K.location+Vt,St.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=St.meshPerAttribute*St.count)}else for(let Vt=0;Vt<K.locationSize;Vt++)g(K.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Vt=0;Vt<K.locationSize;Vt++)T(K.location+Vt,dt/K.locationSize,mt,st,Gt*xt,(ie+dt/K.locationSize*Vt)*xt,At)}else{if(Q.isInstancedBufferAttribute){for(let St=0;St<K.locationSize;St++)p(K.location+St,Q.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let St=0;St<K.locationSize;St++)g(K.location+St);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let St=0;St<K.locationSize;St++)T(K.location+St,dt/K.locationSize,mt,st,dt*xt,dt/K.locationSize*St*xt,At)}}else if(z!==void 0){let st=z[ct];if(st!==void 0)switch(st.length){case 2:n.vertexAttrib2fv(K.location,st);break;case 3:n.vertexAttrib3fv(K.location,st);break;case 4:n.vertexAttrib4fv(K.location,st);break;default:n.vertexAttrib1fv(K.location,st)}}}}y()}function R(){k();for(let I in i){let V=i[I];for(let G in V){let D=V[G];for(let H in D){let Z=D[H];for(let z in Z)h(Z[z].object),delete Z[z];delete D[H]}}delete i[I]}}function A(I){if(i[I.id]===void 0)return;let V=i[I.id];for(let G in V){let D=V[G];for(let H in D){let Z=D[H];for(let z in Z)h(Z[z].object),delete Z[z];delete D[H]}}delete i[I.id]}function _(I){for(let V in i){let G=i[V];for(let D in G){let H=G[D];if(H[I.id]===void 0)continue;let Z=H[I.id];for(let z in Z)h(Z[z].object),delete Z[z];delete H[I.id]}}}function E(I){for(let V in i){let G=i[V],D=I.isInstancedMesh===!0?I.id:0,H=G[D];if(H!==void 0){for(let Z in H){let z=H[Z];for(let ct in z)h(z[ct].object),delete z[ct];delete H[Z]}delete G[D],Object.keys(G).length===0&&delete i[V]}}}function k(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:N,dispose:R,releaseStatesOfGeometry:A,releaseStatesOfObject:E,releaseStatesOfProgram:_,initAttributes:v,enableAttribute:g,disableUnusedAttributes:y}}function qw(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let u=0;for(let f=0;f<h;f++)u+=c[f];e.update(u,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Yw(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==qi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let E=_===Fn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==dn&&_!==$i&&!E&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Yt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&Yt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&Yt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:m,maxTextureSize:v,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:y,maxVaryings:T,maxFragmentUniforms:M,maxSamples:R,samples:A}}function Zw(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Nn,a=new Qt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||i!==0||s;return s=u,i=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,f){let m=d.clippingPlanes,v=d.clipIntersection,g=d.clipShadows,p=n.get(d);if(!s||m===null||m.length===0||r&&!g)r?h(null):c();else{let y=r?0:i,T=y*4,M=p.clippingState||null;l.value=M,M=h(m,u,T,f);for(let R=0;R!==T;++R)M[R]=e[R];p.clippingState=M,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(d,u,f,m){let v=d!==null?d.length:0,g=null;if(v!==0){if(g=l.value,m!==!0||g===null){let p=f+v*4,y=u.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<p)&&(g=new Float32Array(p));for(let T=0,M=f;T!==v;++T,M+=4)o.copy(d[T]).applyMatrix4(y,a),o.normal.toArray(g,M),g[M+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,g}}var Da=class extends Wi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new ma(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new _o(5,5,5),r=new Kn({name:"CubemapFromEquirect",uniforms:_r(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Xi,blending:xs});r.uniforms.tEquirect.value=e;let o=new yi(s,r),a=e.minFilter;return e.minFilter===vs&&(e.minFilter=Ci),new vo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},g0=256,Kw=3,Jw=20,B0=256,z0=16,jw=3,Qw=new J,t1=new _e,Dh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new vo(1,10,null),this._boxMesh=new yi(new _o(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=Qw}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,v=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(t.background=l.getClearColor(t1));let g=new vo(i,s,h);return g.position.copy(a),g.update(l,t),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=m,t.background=v,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=v0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=x0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(g0,u0(t))}_fromTexture(t,e){t.mapping===mr||t.mapping===So?this._setSize(t.image.length===0?g0:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=_0(t,!1,!1),i=Math.log2(t)-Kw;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=_0(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===mr||t.mapping===So?(this._cubemapMaterial===null&&(this._cubemapMaterial=v0()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=x0()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=e1(),this._integrationMaterial=i1());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/z0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-jw)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(B0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=n1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function _0(n,t,e){return new Da(n,{minFilter:vs,generateMipmaps:t,type:Fn,colorSpace:Us,depthBuffer:e})}function Fa(n,t,e){return new Kn({name:n,uniforms:t,vertexShader:ae.cube_vert,fragmentShader:e,side:Xi,blending:xs,depthTest:!1,depthWrite:!1})}function e1(){return Fa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${B0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function i1(){return Fa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:z0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function n1(){return Fa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Jw}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function x0(){return Fa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function v0(){return Fa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function s1(n){let t=new WeakMap,e=new WeakMap,i=null;function s(u,f=!1){return u==null?null:f?o(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===qc||f===Yc)if(t.has(u)){let m=t.get(u).texture;return a(m,u.mapping)}else{let m=u.image;if(m&&m.height>0){let v=new Da(m.height);return v.fromEquirectangularTexture(n,u),t.set(u,v),u.addEventListener("dispose",c),a(v.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,m=f===qc||f===Yc,v=f===mr||f===So;if(m||v){let g=e.get(u),p=g!==void 0?g.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==p)return i===null&&(i=new Dh(n)),g=m?i.fromEquirectangular(u,g):i.fromCubemap(u,g),g.texture.pmremVersion=u.pmremVersion,e.set(u,g),g.texture;if(g!==void 0)return g.texture;{let y=u.image;return m&&y&&y.height>0||v&&y&&l(y)?(i===null&&(i=new Dh(n)),g=m?i.fromEquirectangular(u):i.fromCubemap(u),g.texture.pmremVersion=u.pmremVersion,e.set(u,g),u.addEventListener("dispose",h),g.texture):null}}}return u}function a(u,f){return f===qc?u.mapping=mr:f===Yc&&(u.mapping=So),u}function l(u){let f=0,m=6;for(let v=0;v<m;v++)u[v]!==void 0&&f++;return f===m}function c(u){let f=u.target;f.removeEventListener("dispose",c);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function h(u){let f=u.target;f.removeEventListener("dispose",h);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function d(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function r1(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&ra("WebGLRenderer: "+i+" extension not supported."),s}}}function o1(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let g in m.attributes)t.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let v=r.get(m);v&&(t.remove(v),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),e.memory.geometries++),v}function h(m){let v=m.attributes;for(let g in v)t.update(v[g],n.ARRAY_BUFFER)}function d(m){let v=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let y=v!==null?v.array.length:g.array.length/3-1,T=g.count>=65535?fa:da,M=new T(Math.ceil(y/3)*6,1),R=M.array;if(v!==null){let _=v.array;p=v.version;for(let E=0,k=0;E<y;E+=3){let N=_[E+0],I=_[E+1],V=_[E+2];R[k++]=N,R[k++]=I,R[k++]=I,R[k++]=V,R[k++]=V,R[k++]=N}}else{p=g.version;for(let _=0,E=0;_<y;_+=3){let k=_+0,N=_+1,I=_+2;R[E++]=k,R[E++]=N,R[E++]=N,R[E++]=I,R[E++]=I,R[E++]=k}}M.version=p;let A=r.get(m);A&&t.remove(A),r.set(m,M)}function u(m){let v=r.get(m);if(v){let g=m.index;g!==null&&v.version<g.version&&d(m)}else d(m);return r.get(m)}function f(){for(let m in s){let v=s[m].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:u,dispose:f}}function a1(n,t,e){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){n.drawElements(i,u,r,d*o),e.update(u,i,1)}function c(d,u,f){f!==0&&(n.drawElementsInstanced(i,u,r,d*o,f),e.update(u,i,f))}function h(d,u,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,r,d,0,f);let v=0;for(let g=0;g<f;g++)v+=u[g];e.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function l1(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:jt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function c1(n,t,e){let i=new WeakMap,s=new Ze;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=i.get(a);if(u===void 0||u.count!==d){let k=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",k)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],T=0;f===!0&&(T=1),m===!0&&(T=2),v===!0&&(T=3);let M=a.attributes.position.count*T,R=1;M>t.maxTextureSize&&(R=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);let A=new Float32Array(M*R*4*d),_=new ha(A,M,R,d);_.type=$i,_.needsUpdate=!0;let E=T*4;for(let N=0;N<d;N++){let I=g[N],V=p[N],G=y[N],D=M*R*4*N;for(let H=0;H<I.count;H++){let Z=H*E;f===!0&&(s.fromBufferAttribute(I,H),A[D+Z+0]=s.x,A[D+Z+1]=s.y,A[D+Z+2]=s.z,A[D+Z+3]=0),m===!0&&(s.fromBufferAttribute(V,H),A[D+Z+4]=s.x,A[D+Z+5]=s.y,A[D+Z+6]=s.z,A[D+Z+7]=0),v===!0&&(s.fromBufferAttribute(G,H),A[D+Z+8]=s.x,A[D+Z+9]=s.y,A[D+Z+10]=s.z,A[D+Z+11]=G.itemSize===4?s.w:1)}}u={count:d,texture:_,size:new ge(M,R)},i.set(a,u),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:r}}function h1(n,t,e,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,d=c.geometry,u=t.get(c,d);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var u1={[Fd]:"LINEAR_TONE_MAPPING",[Ud]:"REINHARD_TONE_MAPPING",[Od]:"CINEON_TONE_MAPPING",[kd]:"ACES_FILMIC_TONE_MAPPING",[zd]:"AGX_TONE_MAPPING",[Vd]:"NEUTRAL_TONE_MAPPING",[Bd]:"CUSTOM_TONE_MAPPING"};function d1(n,t,e,i,s,r){let o=new Wi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new mi;h.setAttribute("position",new yn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new yn([0,2,0,0,2,0],2));let d=new xo({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new yi(h,d),f=new Gc(-1,1,1,-1,0,1),m=null,v=null,g=!1,p,y=null,T=[],M=!1;this.setSize=function(R,A){o.setSize(R,A),a!==null&&a.setSize(R,A),l!==null&&l.setSize(R,A);for(let _=0;_<T.length;_++){let E=T[_];E.setSize&&E.setSize(R,A)}},this.setEffects=function(R){T=R,M=T.length>0&&T[0].isRenderPass===!0;let A=o.width,_=o.height;T.length>0&&a===null&&(a=new Wi(A,_,{type:Fn,depthBuffer:!1,stencilBuffer:!1}),l=new Wi(A,_,{type:Fn,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&T.some(k=>k.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new _s(A,_),r===!0&&(c.format=ys,c.type=gr)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let k=0;k<T.length;k++){let N=T[k];N.setSize&&N.setSize(A,_),E&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(R,A){if(g||R.toneMapping===Jn&&T.length===0)return!1;if(y=A,A!==null){let _=A.width,E=A.height;(o.width!==_||o.height!==E)&&this.setSize(_,E)}return M===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=Jn,!0},this.hasRenderPass=function(){return M},this.end=function(R,A){R.toneMapping=p,g=!0;let _=o,E=a;for(let k=0;k<T.length;k++){let N=T[k];N.enabled!==!1&&(N.render(R,E,_,A),N.needsSwap!==!1&&(_=E,E=E===a?l:a))}if(m!==R.outputColorSpace||v!==R.toneMapping){m=R.outputColorSpace,v=R.toneMapping,d.defines={},me.getTransfer(m)===Ee&&(d.defines.SRGB_TRANSFER="");let k=u1[v];k&&(d.defines[k]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,R.setRenderTarget(y),R.render(u,f),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var V0=new Ji,H0=new _s(1,1),G0=new ga(1),W0=new ha,X0=new Ac,$0=new ma,y0=[],M0=[],S0=new Float32Array(16),b0=new Float32Array(9),w0=new Float32Array(4);function Eo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=y0[s];if(r===void 0&&(r=new Float32Array(s),y0[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Mi(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Si(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Uh(n,t){let e=M0[t];e===void 0&&(e=new Int32Array(t),M0[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function f1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function p1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mi(e,t))return;n.uniform2fv(this.addr,t),Si(e,t)}}function m1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Mi(e,t))return;n.uniform3fv(this.addr,t),Si(e,t)}}function g1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mi(e,t))return;n.uniform4fv(this.addr,t),Si(e,t)}}function _1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Mi(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Si(e,t)}else{if(Mi(e,i))return;w0.set(i),n.uniformMatrix2fv(this.addr,!1,w0),Si(e,i)}}function x1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Mi(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Si(e,t)}else{if(Mi(e,i))return;b0.set(i),n.uniformMatrix3fv(this.addr,!1,b0),Si(e,i)}}function v1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Mi(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Si(e,t)}else{if(Mi(e,i))return;S0.set(i),n.uniformMatrix4fv(this.addr,!1,S0),Si(e,i)}}function y1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function M1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mi(e,t))return;n.uniform2iv(this.addr,t),Si(e,t)}}function S1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mi(e,t))return;n.uniform3iv(this.addr,t),Si(e,t)}}function b1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mi(e,t))return;n.uniform4iv(this.addr,t),Si(e,t)}}function w1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function E1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mi(e,t))return;n.uniform2uiv(this.addr,t),Si(e,t)}}function T1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mi(e,t))return;n.uniform3uiv(this.addr,t),Si(e,t)}}function A1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mi(e,t))return;n.uniform4uiv(this.addr,t),Si(e,t)}}function Oh(n){return n.version===0&&(n.compareFunction=Qd,n.needsUpdate=!0),n}function R1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Oh(H0):r=V0,e.setTexture2D(t||r,s)}function C1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||X0,s)}function P1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Oh(G0):r=$0,e.setTextureCube(t||r,s)}function I1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||W0,s)}function L1(n){switch(n){case 5126:return f1;case 35664:return p1;case 35665:return m1;case 35666:return g1;case 35674:return _1;case 35675:return x1;case 35676:return v1;case 5124:case 35670:return y1;case 35667:case 35671:return M1;case 35668:case 35672:return S1;case 35669:case 35673:return b1;case 5125:return w1;case 36294:return E1;case 36295:return T1;case 36296:return A1;case 35678:case 36198:case 36298:case 36306:case 35682:return R1;case 35679:case 36299:case 36307:return C1;case 35680:case 36300:case 36308:case 36293:return P1;case 36289:case 36303:case 36311:case 36292:return I1}}function N1(n,t){n.uniform1fv(this.addr,t)}function D1(n,t){let e=Eo(t,this.size,2);n.uniform2fv(this.addr,e)}function F1(n,t){let e=Eo(t,this.size,3);n.uniform3fv(this.addr,e)}function U1(n,t){let e=Eo(t,this.size,4);n.uniform4fv(this.addr,e)}function O1(n,t){let e=Eo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function k1(n,t){let e=Eo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function B1(n,t){let e=Eo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function z1(n,t){n.uniform1iv(this.addr,t)}function V1(n,t){n.uniform2iv(this.addr,t)}function H1(n,t){n.uniform3iv(this.addr,t)}function G1(n,t){n.uniform4iv(this.addr,t)}function W1(n,t){n.uniform1uiv(this.addr,t)}function X1(n,t){n.uniform2uiv(this.addr,t)}function $1(n,t){n.uniform3uiv(this.addr,t)}function q1(n,t){n.uniform4uiv(this.addr,t)}function Y1(n,t,e){let i=this.cache,s=t.length,r=Uh(e,s);Mi(i,r)||(n.uniform1iv(this.addr,r),Si(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Oh(H0):o=V0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Z1(n,t,e){let i=this.cache,s=t.length,r=Uh(e,s);Mi(i,r)||(n.uniform1iv(this.addr,r),Si(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||X0,r[o])}function K1(n,t,e){let i=this.cache,s=t.length,r=Uh(e,s);Mi(i,r)||(n.uniform1iv(this.addr,r),Si(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Oh(G0):o=$0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function J1(n,t,e){let i=this.cache,s=t.length,r=Uh(e,s);Mi(i,r)||(n.uniform1iv(this.addr,r),Si(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||W0,r[o])}function j1(n){switch(n){case 5126:return N1;case 35664:return D1;case 35665:return F1;case 35666:return U1;case 35674:return O1;case 35675:return k1;case 35676:return B1;case 5124:case 35670:return z1;case 35667:case 35671:return V1;case 35668:case 35672:return H1;case 35669:case 35673:return G1;case 5125:return W1;case 36294:return X1;case 36295:return $1;case 36296:return q1;case 35678:case 36198:case 36298:case 36306:case 35682:return Y1;case 35679:case 36299:case 36307:return Z1;case 35680:case 36300:case 36308:case 36293:return K1;case 36289:case 36303:case 36311:case 36292:return J1}}var cf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=L1(e.type)}},hf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=j1(e.type)}},uf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},af=/(\w+)(\])?(\[|\.)?/g;function E0(n,t){n.seq.push(t),n.map[t.id]=t}function Q1(n,t,e){let i=n.name,s=i.length;for(af.lastIndex=0;;){let r=af.exec(i),o=af.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){E0(e,c===void 0?new cf(a,n,t):new hf(a,n,t));break}else{let d=e.map[a];d===void 0&&(d=new uf(a),E0(e,d)),e=d}}}var wo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);Q1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function T0(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var tE=37297,eE=0;function iE(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var A0=new Qt;function nE(n){me._getMatrix(A0,me.workingColorSpace,n);let t=`mat3( ${A0.elements.map(e=>e.toFixed(4))} )`;switch(me.getTransfer(n)){case aa:return[t,"LinearTransferOETF"];case Ee:return[t,"sRGBTransferOETF"];default:return Yt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function R0(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+iE(n.getShaderSource(t),a)}else return r}function sE(n,t){let e=nE(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var rE={[Fd]:"Linear",[Ud]:"Reinhard",[Od]:"Cineon",[kd]:"ACESFilmic",[zd]:"AgX",[Vd]:"Neutral",[Bd]:"Custom"};function oE(n,t){let e=rE[t];return e===void 0?(Yt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Nh=new J;function aE(){me.getLuminanceCoefficients(Nh);let n=Nh.x.toFixed(4),t=Nh.y.toFixed(4),e=Nh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function lE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Na).join(`
`)}function cE(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function hE(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Na(n){return n!==""}function C0(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function P0(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var uE=/^[ \t]*#include +<([\w\d./]+)>/gm;function df(n){return n.replace(uE,dE)}function dE(n,t){let e=ae[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return df(e)}var fE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function I0(n){return n.replace(fE,pE)}function pE(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function L0(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var mE={[ya]:"SHADOWMAP_TYPE_PCF",[yo]:"SHADOWMAP_TYPE_VSM"};function gE(n){return mE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var _E={[So]:"ENVMAP_MODE_REFRACTION"};function xE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":_E[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var vE={[Dd]:"ENVMAP_BLENDING_MULTIPLY",[Zg]:"ENVMAP_BLENDING_MIX",[Kg]:"ENVMAP_BLENDING_ADD"};function yE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":vE[n.combine]||"ENVMAP_BLENDING_NONE"}function ME(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=gE(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=xE(e),d=yE(e),u=lE(e),f=cE(r),m=s.createProgram(),v,g,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(v=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Na).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Na).join(`
`),g.length>0&&(g+=`
`)):(v=[L0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Na).join(`
`),g=[L0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Jn?"#define TONE_MAPPING":"",e.toneMapping!==Jn?ae.tonemapping_pars_fragment:"",e.toneMapping!==Jn?oE("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ae.colorspace_pars_fragment,sE("linearToOutputTexel",e.outputColorSpace),aE(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Na).join(`
`)),o=df(o),o=C0(o,e),o=P0(o,e),a=df(a),a=C0(a,e),a=P0(a,e),o=I0(o),a=I0(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,v=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",e.glslVersion===Pa?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Pa?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=p+v+o,T=p+g+a,M=T0(s,s.VERTEX_SHADER,y),R=T0(s,s.FRAGMENT_SHADER,T);s.attachShader(m,M),s.attachShader(m,R),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function A(N){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(m)||"",V=s.getShaderInfoLog(M)||"",G=s.getShaderInfoLog(R)||"",D=I.trim(),H=V.trim(),Z=G.trim(),z=!0,ct=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,M,R);else{let K=R0(s,M,"vertex"),Q=R0(s,R,"fragment");jt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+D+`
`+K+`
`+Q)}else D!==""?Yt("WebGLProgram: Program Info Log:",D):(H===""||Z==="")&&(ct=!1);ct&&(N.diagnostics={runnable:z,programLog:D,vertexShader:{log:H,prefix:v},fragmentShader:{log:Z,prefix:g}})}s.deleteShader(M),s.deleteShader(R),_=new wo(s,m),E=hE(s,m)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let k=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(m,tE)),k},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=eE++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=M,this.fragmentShader=R,this}var SE=0,ff=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new pf(t),e.set(t,i)),i}},pf=class{constructor(t){this.id=SE++,this.code=t,this.usedTimes=0}};function bE(n){return n===Ws||n===Aa||n===Ra}function wE(n,t,e,i,s,r){let o=new ua,a=new ff,l=new Set,c=[],h=new Map,d=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function m(_,E,k,N,I,V){let G=N.fog,D=I.geometry,H=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?N.environment:null,Z=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,z=t.get(_.envMap||H,Z),ct=u[_.type],K=i.precision;_.precision!==null&&(K=i.getMaxPrecision(_.precision),K!==_.precision&&Yt("WebGLProgram.getParameters:",_.precision,"not supported, using",K,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,st=Q!==void 0?Q.length:0,dt=0;D.morphAttributes.position!==void 0&&(dt=1),D.morphAttributes.normal!==void 0&&(dt=2),D.morphAttributes.color!==void 0&&(dt=3);let ut,tt,mt,xt;if(ct){let Rt=Qn[ct];ut=Rt.vertexShader,tt=Rt.fragmentShader}else{ut=_.vertexShader,tt=_.fragmentShader;let Rt=a.getVertexShaderStage(_),se=a.getFragmentShaderStage(_);a.update(_,Rt,se),mt=Rt.id,xt=se.id}let At=n.getRenderTarget(),St=n.state.buffers.depth.getReversed(),Gt=I.isInstancedMesh===!0,ie=I.isBatchedMesh===!0,Vt=!!_.map,le=!!_.matcap,re=!!z,te=re&&z.isPMREMTexture===!0,We=!!_.aoMap,De=!!_.lightMap,ri=!!_.bumpMap&&_.wireframe===!1,Ce=!!_.normalMap,bi=!!_.displacementMap,ve=!!_.emissiveMap,gi=!!_.metalnessMap,Ke=!!_.roughnessMap,oi=_.anisotropy>0,U=_.clearcoat>0,Ct=_.diffuseRoughness>0,$t=_.dispersion>0,ne=_.retroreflectivity>0,bt=_.iridescence>0,Ie=_.sheen>0,zt=_.transmission>0,Xt=oi&&!!_.anisotropyMap,C=U&&!!_.clearcoatMap,S=U&&!!_.clearcoatNormalMap,X=U&&!!_.clearcoatRoughnessMap,ht=Ct&&!!_.diffuseRoughnessMap,ot=bt&&!!_.iridescenceMap,_t=bt&&!!_.iridescenceThicknessMap,vt=Ie&&!!_.sheenColorMap,et=Ie&&!!_.sheenRoughnessMap,nt=!!_.specularMap,pt=!!_.specularColorMap,F=!!_.specularIntensityMap,rt=zt&&!!_.transmissionMap,it=zt&&!!_.thicknessMap,wt=!!_.gradientMap,gt=!!_.alphaMap,Mt=_.alphaTest>0,Ht=!!_.alphaHash,Zt=!!_.extensions,lt=Jn;_.toneMapped&&(At===null||At.isXRRenderTarget===!0)&&(lt=n.toneMapping);let Ot=te?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,Kt={shaderID:ct,shaderType:_.type,shaderName:_.name,vertexShader:ut,fragmentShader:tt,defines:_.defines,customVertexShaderID:mt,customFragmentShaderID:xt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:K,batching:ie,batchingColor:ie&&I._colorsTexture!==null,instancing:Gt,instancingColor:Gt&&I.instanceColor!==null,instancingMorph:Gt&&I.morphTexture!==null,outputColorSpace:At===null?n.outputColorSpace:At.isXRRenderTarget===!0?At.texture.colorSpace:me.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Vt,matcap:le,envMap:re,envMapMode:re&&z.mapping,envMapPMREM:te,envMapMaxLod:te?Ot.length-1:null,envMapSize:te?Ot[0].width:null,aoMap:We,lightMap:De,bumpMap:ri,normalMap:Ce,displacementMap:bi,emissiveMap:ve,normalMapObjectSpace:Ce&&_.normalMapType===Qg,normalMapTangentSpace:Ce&&_.normalMapType===Kd,packedNormalMap:Ce&&_.normalMapType===Kd&&bE(_.normalMap.format),metalnessMap:gi,roughnessMap:Ke,anisotropy:oi,anisotropyMap:Xt,clearcoat:U,clearcoatMap:C,clearcoatNormalMap:S,clearcoatRoughnessMap:X,diffuseRoughness:Ct,diffuseRoughnessMap:ht,dispersion:$t,retroreflection:ne,iridescence:bt,iridescenceMap:ot,iridescenceThicknessMap:_t,sheen:Ie,sheenColorMap:vt,sheenRoughnessMap:et,specularMap:nt,specularColorMap:pt,specularIntensityMap:F,transmission:zt,transmissionMap:rt,thicknessMap:it,gradientMap:wt,opaque:_.transparent===!1&&_.blending===Mo&&_.alphaToCoverage===!1,alphaMap:gt,alphaTest:Mt,alphaHash:Ht,combine:_.combine,mapUv:Vt&&f(_.map.channel),aoMapUv:We&&f(_.aoMap.channel),lightMapUv:De&&f(_.lightMap.channel),bumpMapUv:ri&&f(_.bumpMap.channel),normalMapUv:Ce&&f(_.normalMap.channel),displacementMapUv:bi&&f(_.displacementMap.channel),emissiveMapUv:ve&&f(_.emissiveMap.channel),metalnessMapUv:gi&&f(_.metalnessMap.channel),roughnessMapUv:Ke&&f(_.roughnessMap.channel),anisotropyMapUv:Xt&&f(_.anisotropyMap.channel),clearcoatMapUv:C&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ht&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:et&&f(_.sheenRoughnessMap.channel),specularMapUv:nt&&f(_.specularMap.channel),specularColorMapUv:pt&&f(_.specularColorMap.channel),specularIntensityMapUv:F&&f(_.specularIntensityMap.channel),transmissionMapUv:rt&&f(_.transmissionMap.channel),thicknessMapUv:it&&f(_.thicknessMap.channel),alphaMapUv:gt&&f(_.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Ce||oi),vertexNormals:!!D.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!D.attributes.uv&&(Vt||gt),fog:!!G,useFog:_.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||D.attributes.normal===void 0&&Ce===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:St,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:st,morphTextureStride:dt,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:V.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&k.length>0,shadowMapType:n.shadowMap.type,toneMapping:lt,decodeVideoTexture:Vt&&_.map.isVideoTexture===!0&&me.getTransfer(_.map.colorSpace)===Ee,decodeVideoTextureEmissive:ve&&_.emissiveMap.isVideoTexture===!0&&me.getTransfer(_.emissiveMap.colorSpace)===Ee,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Mn,flipSided:_.side===Xi,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Zt&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Zt&&_.extensions.multiDraw===!0||ie)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Kt.vertexUv1s=l.has(1),Kt.vertexUv2s=l.has(2),Kt.vertexUv3s=l.has(3),l.clear(),Kt}function v(_){let E=[];if(_.shaderID?E.push(_.shaderID):(E.push(_.customVertexShaderID),E.push(_.customFragmentShaderID)),_.defines!==void 0)for(let k in _.defines)E.push(k),E.push(_.defines[k]);return _.isRawShaderMaterial===!1&&(g(E,_),p(E,_),E.push(n.outputColorSpace)),E.push(_.customProgramCacheKey),E.join()}function g(_,E){_.push(E.precision),_.push(E.outputColorSpace),_.push(E.envMapMode),_.push(E.envMapPMREM),_.push(E.envMapMaxLod),_.push(E.envMapSize),_.push(E.mapUv),_.push(E.alphaMapUv),_.push(E.lightMapUv),_.push(E.aoMapUv),_.push(E.bumpMapUv),_.push(E.normalMapUv),_.push(E.displacementMapUv),_.push(E.emissiveMapUv),_.push(E.metalnessMapUv),_.push(E.roughnessMapUv),_.push(E.anisotropyMapUv),_.push(E.clearcoatMapUv),_.push(E.clearcoatNormalMapUv),_.push(E.clearcoatRoughnessMapUv),_.push(E.diffuseRoughnessMapUv),_.push(E.iridescenceMapUv),_.push(E.iridescenceThicknessMapUv),_.push(E.sheenColorMapUv),_.push(E.sheenRoughnessMapUv),_.push(E.specularMapUv),_.push(E.specularColorMapUv),_.push(E.specularIntensityMapUv),_.push(E.transmissionMapUv),_.push(E.thicknessMapUv),_.push(E.combine),_.push(E.fogExp2),_.push(E.sizeAttenuation),_.push(E.morphTargetsCount),_.push(E.numSunLights),_.push(E.numDirLights),_.push(E.numPointLights),_.push(E.numSpotLights),_.push(E.numSpotLightMaps),_.push(E.numHemiLights),_.push(E.numRectAreaLights),_.push(E.numSunLightShadows),_.push(E.numDirLightShadows),_.push(E.numPointLightShadows),_.push(E.numSpotLightShadows),_.push(E.numSpotLightShadowsWithMaps),_.push(E.numLightProbes),_.push(E.numLightProbeGrids),_.push(E.shadowMapType),_.push(E.toneMapping),_.push(E.numClippingPlanes),_.push(E.numClipIntersection),_.push(E.depthPacking)}function p(_,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let E=u[_.type],k;if(E){let N=Qn[E];k=f0.clone(N.uniforms)}else k=_.uniforms;return k}function T(_,E){let k=h.get(E);return k!==void 0?++k.usedTimes:(k=new ME(n,E,_,s),c.push(k),h.set(E,k)),k}function M(_){if(--_.usedTimes===0){let E=c.indexOf(_);c[E]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function R(_){a.remove(_)}function A(){a.dispose()}return{getParameters:m,getProgramCacheKey:v,getUniforms:y,acquireProgram:T,releaseProgram:M,releaseShaderCache:R,programs:c,dispose:A}}function EE(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function TE(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function N0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function D0(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function a(u,f,m,v,g,p){let y=n[t];return y===void 0?(y={id:u.id,object:u,geometry:f,material:m,materialVariant:o(u),groupOrder:v,renderOrder:u.renderOrder,z:g,group:p},n[t]=y):(y.id=u.id,y.object=u,y.geometry=f,y.material=m,y.materialVariant=o(u),y.groupOrder=v,y.renderOrder=u.renderOrder,y.z=g,y.group=p),t++,y}function l(u,f,m,v,g,p,y){y.reversedDepth===!0&&(g=-g);let T=a(u,f,m,v,g,p);m.transmission>0?i.push(T):m.transparent===!0?s.push(T):e.push(T)}function c(u,f,m,v,g,p){let y=a(u,f,m,v,g,p);m.transmission>0?i.unshift(y):m.transparent===!0?s.unshift(y):e.unshift(y)}function h(u,f){e.length>1&&e.sort(u||TE),i.length>1&&i.sort(f||N0),s.length>1&&s.sort(f||N0)}function d(){for(let u=t,f=n.length;u<f;u++){let m=n[u];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function AE(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new D0,n.set(i,[o])):s>=r.length?(o=new D0,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function RE(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new J,color:new _e};break;case"SpotLight":e={position:new J,direction:new J,color:new _e,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new J,color:new _e,distance:0,decay:0};break;case"HemisphereLight":e={direction:new J,skyColor:new _e,groundColor:new _e};break;case"RectAreaLight":e={color:new _e,position:new J,halfWidth:new J,halfHeight:new J};break}return n[t.id]=e,e}}}function CE(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ge};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ge};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ge,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var PE=0;function IE(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function LE(n){let t=new RE,e=CE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new J);let s=new J,r=new Ue,o=new Ue;function a(c){let h=0,d=0,u=0;for(let V=0;V<9;V++)i.probe[V].set(0,0,0);let f=0,m=0,v=0,g=0,p=0,y=0,T=0,M=0,R=0,A=0,_=0,E=0,k=0,N=0;c.sort(IE);for(let V=0,G=c.length;V<G;V++){let D=c[V],H=D.color,Z=D.intensity,z=D.distance,ct=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Ws?ct=D.shadow.map.texture:ct=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=H.r*Z,d+=H.g*Z,u+=H.b*Z;else if(D.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(D.sh.coefficients[K],Z);N++}else if(D.isSunLight){let K=t.get(D);if(K.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,st=e.get(D);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[m]=st,i.sunShadowMap[m]=ct;let dt=Q.getViewportCount();for(let ut=0;ut<dt;ut++)i.sunShadowMatrix[v+ut]=Q.getMatrix(ut),i.sunShadowCascade[v+ut]=Q._cascadeData[ut];v+=dt,m++}i.sun[f]=K,f++}else if(D.isDirectionalLight){let K=t.get(D);if(K.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,st=e.get(D);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,i.directionalShadow[g]=st,i.directionalShadowMap[g]=ct,i.directionalShadowMatrix[g]=D.shadow.matrix,R++}i.directional[g]=K,g++}else if(D.isSpotLight){let K=t.get(D);K.position.setFromMatrixPosition(D.matrixWorld),K.color.copy(H).multiplyScalar(Z),K.distance=z,K.coneCos=Math.cos(D.angle),K.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),K.decay=D.decay,i.spot[y]=K;let Q=D.shadow;if(D.map&&(i.spotLightMap[E]=D.map,E++,Q.updateMatrices(D),D.castShadow&&k++),i.spotLightMatrix[y]=Q.matrix,D.castShadow){let st=e.get(D);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,i.spotShadow[y]=st,i.spotShadowMap[y]=ct,_++}y++}else if(D.isRectAreaLight){let K=t.get(D);K.color.copy(H).multiplyScalar(Z),K.halfWidth.set(D.width*.5,0,0),K.halfHeight.set(0,D.height*.5,0),i.rectArea[T]=K,T++}else if(D.isPointLight){let K=t.get(D);if(K.color.copy(D.color).multiplyScalar(D.intensity),K.distance=D.distance,K.decay=D.decay,D.castShadow){let Q=D.shadow,st=e.get(D);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,st.shadowCameraNear=Q.camera.near,st.shadowCameraFar=Q.camera.far,i.pointShadow[p]=st,i.pointShadowMap[p]=ct,i.pointShadowMatrix[p]=D.shadow.matrix,A++}i.point[p]=K,p++}else if(D.isHemisphereLight){let K=t.get(D);K.skyColor.copy(D.color).multiplyScalar(Z),K.groundColor.copy(D.groundColor).multiplyScalar(Z),i.hemi[M]=K,M++}}T>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Lt.LTC_FLOAT_1,i.rectAreaLTC2=Lt.LTC_FLOAT_2):(i.rectAreaLTC1=Lt.LTC_HALF_1,i.rectAreaLTC2=Lt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=d,i.ambient[2]=u;let I=i.hash;(I.sunLength!==f||I.directionalLength!==g||I.pointLength!==p||I.spotLength!==y||I.rectAreaLength!==T||I.hemiLength!==M||I.numSunShadows!==m||I.numDirectionalShadows!==R||I.numPointShadows!==A||I.numSpotShadows!==_||I.numSpotMaps!==E||I.numLightProbes!==N)&&(i.sun.length=f,i.directional.length=g,i.spot.length=y,i.rectArea.length=T,i.point.length=p,i.hemi.length=M,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+E-k,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=k,i.numLightProbes=N,I.sunLength=f,I.directionalLength=g,I.pointLength=p,I.spotLength=y,I.rectAreaLength=T,I.hemiLength=M,I.numSunShadows=m,I.numDirectionalShadows=R,I.numPointShadows=A,I.numSpotShadows=_,I.numSpotMaps=E,I.numLightProbes=N,i.version=PE++)}function l(c,h){let d=0,u=0,f=0,m=0,v=0,g=0,p=h.matrixWorldInverse;for(let y=0,T=c.length;y<T;y++){let M=c[y];if(M.isSunLight){let R=i.sun[d];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(p),d++}else if(M.isDirectionalLight){let R=i.directional[u];R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),u++}else if(M.isSpotLight){let R=i.spot[m];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),m++}else if(M.isRectAreaLight){let R=i.rectArea[v];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),o.identity(),r.copy(M.matrixWorld),r.premultiply(p),o.extractRotation(r),R.halfWidth.set(M.width*.5,0,0),R.halfHeight.set(0,M.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),v++}else if(M.isPointLight){let R=i.point[f];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),f++}else if(M.isHemisphereLight){let R=i.hemi[g];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:i}}function F0(n){let t=new LE(n),e=[],i=[],s=[];function r(d){h.camera=d,e.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){i.push(d)}function l(){t.setup(e),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){t.setupView(e,d)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function NE(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new F0(n),t.set(s,[a])):r>=o.length?(a=new F0(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var DE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,FE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,UE=[new J(1,0,0),new J(-1,0,0),new J(0,1,0),new J(0,-1,0),new J(0,0,1),new J(0,0,-1)],OE=[new J(0,-1,0),new J(0,-1,0),new J(0,0,1),new J(0,0,-1),new J(0,-1,0),new J(0,-1,0)],U0=new Ue,La=new J,lf=new J;function kE(n,t,e){let i=new ur,s=new ge,r=new ge,o=new Ze,a=new Ic,l=new Lc,c={},h=e.maxTextureSize,d={[Gs]:Xi,[Xi]:Gs,[Mn]:Mn},u=new Kn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ge},radius:{value:4}},vertexShader:DE,fragmentShader:FE}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let m=new mi;m.setAttribute("position",new si(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new yi(m,u),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ya;let p=this.type;this.render=function(A,_,E){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===Ng&&(Yt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ya);let k=n.getRenderTarget(),N=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),V=n.state;V.setBlending(xs),V.buffers.depth.getReversed()===!0?V.buffers.color.setClear(0,0,0,0):V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);let G=p!==this.type;G&&_.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(H=>H.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,H=A.length;D<H;D++){let Z=A[D],z=Z.shadow;if(z===void 0){Yt("WebGLShadowMap:",Z,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let ct=z.getFrameExtents();s.multiply(ct),r.copy(z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ct.x),s.x=r.x*ct.x,z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ct.y),s.y=r.y*ct.y,z.mapSize.y=r.y));let K=n.state.buffers.depth.getReversed();if(z.camera._reversedDepth=K,z.map===null||G===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===yo){if(Z.isPointLight){Yt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new Wi(s.x,s.y,{format:Ws,type:Fn,minFilter:Ci,magFilter:Ci,generateMipmaps:!1}),z.map.texture.name=Z.name+".shadowMap",z.map.depthTexture=new _s(s.x,s.y,$i),z.map.depthTexture.name=Z.name+".shadowMapDepth",z.map.depthTexture.format=ms,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=pi,z.map.depthTexture.magFilter=pi}else Z.isPointLight?(z.map=new Da(s.x),z.map.depthTexture=new ga(s.x,Dn)):(z.map=new Wi(s.x,s.y),z.map.depthTexture=new _s(s.x,s.y,Dn)),z.map.depthTexture.name=Z.name+".shadowMap",z.map.depthTexture.format=ms,this.type===ya?(z.map.depthTexture.compareFunction=K?jd:Jd,z.map.depthTexture.minFilter=Ci,z.map.depthTexture.magFilter=Ci):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=pi,z.map.depthTexture.magFilter=pi);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let Q=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();Z.isPointLight!==!0&&z.updateMatrices(Z,E);let st=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:E.layers;for(let dt=0;dt<Q;dt++){let ut=z.getCamera(dt);if(Z.isPointLight){let tt=z.camera,mt=z.matrix,xt=Z.distance||tt.far;xt!==tt.far&&(tt.far=xt,tt.updateProjectionMatrix()),La.setFromMatrixPosition(Z.matrixWorld),tt.position.copy(La),lf.copy(tt.position),lf.add(UE[dt]),tt.up.copy(OE[dt]),tt.lookAt(lf),tt.updateMatrixWorld(),mt.makeTranslation(-La.x,-La.y,-La.z),U0.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),z._frustum.setFromProjectionMatrix(U0,tt.coordinateSystem,tt.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)n.setRenderTarget(z.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(z.map),n.clear());let tt=z.getViewport(dt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),V.viewport(o)}i=z.getFrustum(dt),M(_,E,ut,Z,st,this.type)}z.isPointLightShadow!==!0&&this.type===yo&&y(z,E),z.needsUpdate=!1}p=this.type,g.needsUpdate=!1,n.setRenderTarget(k,N,I)};function y(A,_){let E=t.update(v);u.defines.VSM_SAMPLES!==A.blurSamples&&(u.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new Wi(s.x,s.y,{format:Ws,type:Fn}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),u.uniforms.shadow_pass.value=A.map.depthTexture,u.uniforms.resolution.value.set(A.map.width,A.map.height),u.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(_,null,E,u,v,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(_,null,E,f,v,null)}function T(A,_,E,k){let N=null,I=E.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)N=I;else if(N=E.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let V=N.uuid,G=_.uuid,D=c[V];D===void 0&&(D={},c[V]=D);let H=D[G];H===void 0&&(H=N.clone(),D[G]=H,_.addEventListener("dispose",R)),N=H}if(N.visible=_.visible,N.wireframe=_.wireframe,k===yo?N.side=_.shadowSide!==null?_.shadowSide:_.side:N.side=_.shadowSide!==null?_.shadowSide:d[_.side],N.alphaMap=_.alphaMap,N.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,N.map=_.map,N.clipShadows=_.clipShadows,N.clippingPlanes=_.clippingPlanes,N.clipIntersection=_.clipIntersection,N.displacementMap=_.displacementMap,N.displacementScale=_.displacementScale,N.displacementBias=_.displacementBias,N.wireframeLinewidth=_.wireframeLinewidth,N.linewidth=_.linewidth,E.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let V=n.properties.get(N);V.light=E}return N}function M(A,_,E,k,N,I){if(A.visible===!1)return;if(A.layers.test(N)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===yo)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,A.matrixWorld);let D=t.update(A),H=A.material;if(Array.isArray(H)){let Z=D.groups;for(let z=0,ct=Z.length;z<ct;z++){let K=Z[z],Q=H[K.materialIndex];if(Q&&Q.visible){let st=T(A,Q,k,I);A.onBeforeShadow(n,A,_,E,D,st,K),n.renderBufferDirect(E,null,D,st,A,K),A.onAfterShadow(n,A,_,E,D,st,K)}}}else if(H.visible){let Z=T(A,H,k,I);A.onBeforeShadow(n,A,_,E,D,Z,null),n.renderBufferDirect(E,null,D,Z,A,null),A.onAfterShadow(n,A,_,E,D,Z,null)}}let G=A.children;for(let D=0,H=G.length;D<H;D++)M(G[D],_,E,k,N,I)}function R(A){A.target.removeEventListener("dispose",R);for(let E in c){let k=c[E],N=A.target.uuid;N in k&&(k[N].dispose(),delete k[N])}}}function BE(n,t){function e(){let F=!1,rt=new Ze,it=null,wt=new Ze(0,0,0,0);return{setMask:function(gt){it!==gt&&!F&&(n.colorMask(gt,gt,gt,gt),it=gt)},setLocked:function(gt){F=gt},setClear:function(gt,Mt,Ht,Zt,lt){lt===!0&&(gt*=Zt,Mt*=Zt,Ht*=Zt),rt.set(gt,Mt,Ht,Zt),wt.equals(rt)===!1&&(n.clearColor(gt,Mt,Ht,Zt),wt.copy(rt))},reset:function(){F=!1,it=null,wt.set(-1,0,0,0)}}}function i(){let F=!1,rt=!1,it=null,wt=null,gt=null;return{setReversed:function(Mt){if(rt!==Mt){let Ht=t.get("EXT_clip_control");Mt?Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.ZERO_TO_ONE_EXT):Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.NEGATIVE_ONE_TO_ONE_EXT),rt=Mt;let Zt=gt;gt=null,this.setClear(Zt)}},getReversed:function(){return rt},setTest:function(Mt){Mt?St(n.DEPTH_TEST):Gt(n.DEPTH_TEST)},setMask:function(Mt){it!==Mt&&!F&&(n.depthMask(Mt),it=Mt)},setFunc:function(Mt){if(rt&&(Mt=h0[Mt]),wt!==Mt){switch(Mt){case pc:n.depthFunc(n.NEVER);break;case mc:n.depthFunc(n.ALWAYS);break;case gc:n.depthFunc(n.LESS);break;case fo:n.depthFunc(n.LEQUAL);break;case _c:n.depthFunc(n.EQUAL);break;case xc:n.depthFunc(n.GEQUAL);break;case vc:n.depthFunc(n.GREATER);break;case yc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}wt=Mt}},setLocked:function(Mt){F=Mt},setClear:function(Mt){gt!==Mt&&(gt=Mt,rt&&(Mt=1-Mt),n.clearDepth(Mt))},reset:function(){F=!1,it=null,wt=null,gt=null,rt=!1}}}function s(){let F=!1,rt=null,it=null,wt=null,gt=null,Mt=null,Ht=null,Zt=null,lt=null;return{setTest:function(Ot){F||(Ot?St(n.STENCIL_TEST):Gt(n.STENCIL_TEST))},setMask:function(Ot){rt!==Ot&&!F&&(n.stencilMask(Ot),rt=Ot)},setFunc:function(Ot,Kt,Rt){(it!==Ot||wt!==Kt||gt!==Rt)&&(n.stencilFunc(Ot,Kt,Rt),it=Ot,wt=Kt,gt=Rt)},setOp:function(Ot,Kt,Rt){(Mt!==Ot||Ht!==Kt||Zt!==Rt)&&(n.stencilOp(Ot,Kt,Rt),Mt=Ot,Ht=Kt,Zt=Rt)},setLocked:function(Ot){F=Ot},setClear:function(Ot){lt!==Ot&&(n.clearStencil(Ot),lt=Ot)},reset:function(){F=!1,rt=null,it=null,wt=null,gt=null,Mt=null,Ht=null,Zt=null,lt=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,h={},d={},u={},f=new WeakMap,m=[],v=null,g=!1,p=null,y=null,T=null,M=null,R=null,A=null,_=null,E=new _e(0,0,0),k=0,N=!1,I=null,V=null,G=null,D=null,H=null,Z=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,ct=0,K=n.getParameter(n.VERSION);K.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec(K)[1]),z=ct>=1):K.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),z=ct>=2);let Q=null,st={},dt=n.getParameter(n.SCISSOR_BOX),ut=n.getParameter(n.VIEWPORT),tt=new Ze().fromArray(dt),mt=new Ze().fromArray(ut);function xt(F,rt,it,wt){let gt=new Uint8Array(4),Mt=n.createTexture();n.bindTexture(F,Mt),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ht=0;Ht<it;Ht++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,wt,0,n.RGBA,n.UNSIGNED_BYTE,gt):n.texImage2D(rt+Ht,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,gt);return Mt}let At={};At[n.TEXTURE_2D]=xt(n.TEXTURE_2D,n.TEXTURE_2D,1),At[n.TEXTURE_CUBE_MAP]=xt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),At[n.TEXTURE_2D_ARRAY]=xt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),At[n.TEXTURE_3D]=xt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),St(n.DEPTH_TEST),o.setFunc(fo),ri(!1),Ce(Rd),St(n.CULL_FACE),We(xs);function St(F){h[F]!==!0&&(n.enable(F),h[F]=!0)}function Gt(F){h[F]!==!1&&(n.disable(F),h[F]=!1)}function ie(F,rt){return u[F]!==rt?(n.bindFramebuffer(F,rt),u[F]=rt,F===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=rt),F===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(F,rt){let it=m,wt=!1;if(F){it=f.get(rt),it===void 0&&(it=[],f.set(rt,it));let gt=F.textures;if(it.length!==gt.length||it[0]!==n.COLOR_ATTACHMENT0){for(let Mt=0,Ht=gt.length;Mt<Ht;Mt++)it[Mt]=n.COLOR_ATTACHMENT0+Mt;it.length=gt.length,wt=!0}}else it[0]!==n.BACK&&(it[0]=n.BACK,wt=!0);wt&&n.drawBuffers(it)}function le(F){return v!==F?(n.useProgram(F),v=F,!0):!1}let re={[pr]:n.FUNC_ADD,[Dg]:n.FUNC_SUBTRACT,[Fg]:n.FUNC_REVERSE_SUBTRACT};re[$c]=n.MIN,re[Ug]=n.MAX;let te={[Og]:n.ZERO,[Ma]:n.ONE,[kg]:n.SRC_COLOR,[Ld]:n.SRC_ALPHA,[Wg]:n.SRC_ALPHA_SATURATE,[Hg]:n.DST_COLOR,[zg]:n.DST_ALPHA,[Bg]:n.ONE_MINUS_SRC_COLOR,[Nd]:n.ONE_MINUS_SRC_ALPHA,[Gg]:n.ONE_MINUS_DST_COLOR,[Vg]:n.ONE_MINUS_DST_ALPHA,[Xg]:n.CONSTANT_COLOR,[$g]:n.ONE_MINUS_CONSTANT_COLOR,[qg]:n.CONSTANT_ALPHA,[Yg]:n.ONE_MINUS_CONSTANT_ALPHA};function We(F,rt,it,wt,gt,Mt,Ht,Zt,lt,Ot){if(F===xs){g===!0&&(Gt(n.BLEND),g=!1);return}if(g===!1&&(St(n.BLEND),g=!0),F!==Xc){if(F!==p||Ot!==N){if((y!==pr||R!==pr)&&(n.blendEquation(n.FUNC_ADD),y=pr,R=pr),Ot)switch(F){case Mo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Cd:n.blendFunc(n.ONE,n.ONE);break;case Pd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Id:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:jt("WebGLState: Invalid blending: ",F);break}else switch(F){case Mo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Cd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Pd:jt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Id:jt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:jt("WebGLState: Invalid blending: ",F);break}T=null,M=null,A=null,_=null,E.set(0,0,0),k=0,p=F,N=Ot}return}gt=gt||rt,Mt=Mt||it,Ht=Ht||wt,(rt!==y||gt!==R)&&(n.blendEquationSeparate(re[rt],re[gt]),y=rt,R=gt),(it!==T||wt!==M||Mt!==A||Ht!==_)&&(n.blendFuncSeparate(te[it],te[wt],te[Mt],te[Ht]),T=it,M=wt,A=Mt,_=Ht),(Zt.equals(E)===!1||lt!==k)&&(n.blendColor(Zt.r,Zt.g,Zt.b,lt),E.copy(Zt),k=lt),p=F,N=!1}function De(F,rt){F.side===Mn?Gt(n.CULL_FACE):St(n.CULL_FACE);let it=F.side===Xi;rt&&(it=!it),ri(it),F.blending===Mo&&F.transparent===!1?We(xs):We(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let wt=F.stencilWrite;a.setTest(wt),wt&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),ve(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?St(n.SAMPLE_ALPHA_TO_COVERAGE):Gt(n.SAMPLE_ALPHA_TO_COVERAGE)}function ri(F){I!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),I=F)}function Ce(F){F!==Ig?(St(n.CULL_FACE),F!==V&&(F===Rd?n.cullFace(n.BACK):F===Lg?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Gt(n.CULL_FACE),V=F}function bi(F){F!==G&&(z&&n.lineWidth(F),G=F)}function ve(F,rt,it){F?(St(n.POLYGON_OFFSET_FILL),(D!==rt||H!==it)&&(D=rt,H=it,o.getReversed()&&(rt=-rt,it=-it),n.polygonOffset(rt,it))):Gt(n.POLYGON_OFFSET_FILL)}function gi(F){F?St(n.SCISSOR_TEST):Gt(n.SCISSOR_TEST)}function Ke(F){F===void 0&&(F=n.TEXTURE0+Z-1),Q!==F&&(n.activeTexture(F),Q=F)}function oi(F,rt,it){it===void 0&&(Q===null?it=n.TEXTURE0+Z-1:it=Q);let wt=st[it];wt===void 0&&(wt={type:void 0,texture:void 0},st[it]=wt),(wt.type!==F||wt.texture!==rt)&&(Q!==it&&(n.activeTexture(it),Q=it),n.bindTexture(F,rt||At[F]),wt.type=F,wt.texture=rt)}function U(){let F=st[Q];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Ct(){try{n.compressedTexImage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function $t(){try{n.compressedTexImage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function ne(){try{n.texSubImage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function bt(){try{n.texSubImage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function Ie(){try{n.compressedTexSubImage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function zt(){try{n.compressedTexSubImage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function Xt(){try{n.texStorage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function C(){try{n.texStorage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function S(){try{n.texImage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function X(){try{n.texImage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function ht(F){return d[F]!==void 0?d[F]:n.getParameter(F)}function ot(F,rt){d[F]!==rt&&(n.pixelStorei(F,rt),d[F]=rt)}function _t(F){tt.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),tt.copy(F))}function vt(F){mt.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),mt.copy(F))}function et(F,rt){let it=c.get(rt);it===void 0&&(it=new WeakMap,c.set(rt,it));let wt=it.get(F);wt===void 0&&(wt=n.getUniformBlockIndex(rt,F.name),n.uniformBlockBinding(rt,wt,wt),it.set(F,wt))}function nt(F,rt,it){let gt=c.get(rt).get(F);l[gt]!==it&&(n.bindBufferBase(n.UNIFORM_BUFFER,gt,it),l[gt]=it)}function pt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},d={},Q=null,st={},u={},l={},f=new WeakMap,m=[],v=null,g=!1,p=null,y=null,T=null,M=null,R=null,A=null,_=null,E=new _e(0,0,0),k=0,N=!1,I=null,V=null,G=null,D=null,H=null,tt.set(0,0,n.canvas.width,n.canvas.height),mt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:St,disable:Gt,bindFramebuffer:ie,drawBuffers:Vt,useProgram:le,setBlending:We,setMaterial:De,setFlipSided:ri,setCullFace:Ce,setLineWidth:bi,setPolygonOffset:ve,setScissorTest:gi,activeTexture:Ke,bindTexture:oi,unbindTexture:U,compressedTexImage2D:Ct,compressedTexImage3D:$t,texImage2D:S,texImage3D:X,pixelStorei:ot,getParameter:ht,updateUBOMapping:et,uniformBlockBinding:nt,texStorage2D:Xt,texStorage3D:C,texSubImage2D:ne,texSubImage3D:bt,compressedTexSubImage2D:Ie,compressedTexSubImage3D:zt,scissor:_t,viewport:vt,reset:pt}}function zE(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ge,h=new WeakMap,d=new Set,u,f=new WeakMap,m=new Set,v=new FinalizationRegistry(C=>m.delete(C)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(C,S){return g?new OffscreenCanvas(C,S):ca("canvas")}function y(C,S,X){let ht=1,ot=Xt(C);if((ot.width>X||ot.height>X)&&(ht=X/Math.max(ot.width,ot.height)),ht<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let _t=Math.floor(ht*ot.width),vt=Math.floor(ht*ot.height);u===void 0&&(u=p(_t,vt));let et=S?p(_t,vt):u;return et.width=_t,et.height=vt,et.getContext("2d").drawImage(C,0,0,_t,vt),Yt("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+_t+"x"+vt+")."),et}else return"data"in C&&Yt("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),C;return C}function T(C){return C.generateMipmaps}function M(C){n.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?n.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(C,S,X,ht,ot,_t=!1){if(C!==null){if(n[C]!==void 0)return n[C];Yt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let vt;ht&&(vt=t.get("EXT_texture_norm16"),vt||Yt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=S;if(S===n.RED&&(X===n.FLOAT&&(et=n.R32F),X===n.HALF_FLOAT&&(et=n.R16F),X===n.UNSIGNED_BYTE&&(et=n.R8),X===n.UNSIGNED_SHORT&&vt&&(et=vt.R16_EXT),X===n.SHORT&&vt&&(et=vt.R16_SNORM_EXT)),S===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(et=n.R8UI),X===n.UNSIGNED_SHORT&&(et=n.R16UI),X===n.UNSIGNED_INT&&(et=n.R32UI),X===n.BYTE&&(et=n.R8I),X===n.SHORT&&(et=n.R16I),X===n.INT&&(et=n.R32I)),S===n.RG&&(X===n.FLOAT&&(et=n.RG32F),X===n.HALF_FLOAT&&(et=n.RG16F),X===n.UNSIGNED_BYTE&&(et=n.RG8),X===n.UNSIGNED_SHORT&&vt&&(et=vt.RG16_EXT),X===n.SHORT&&vt&&(et=vt.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(et=n.RG8UI),X===n.UNSIGNED_SHORT&&(et=n.RG16UI),X===n.UNSIGNED_INT&&(et=n.RG32UI),X===n.BYTE&&(et=n.RG8I),X===n.SHORT&&(et=n.RG16I),X===n.INT&&(et=n.RG32I)),S===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(et=n.RGB8UI),X===n.UNSIGNED_SHORT&&(et=n.RGB16UI),X===n.UNSIGNED_INT&&(et=n.RGB32UI),X===n.BYTE&&(et=n.RGB8I),X===n.SHORT&&(et=n.RGB16I),X===n.INT&&(et=n.RGB32I)),S===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),X===n.UNSIGNED_INT&&(et=n.RGBA32UI),X===n.BYTE&&(et=n.RGBA8I),X===n.SHORT&&(et=n.RGBA16I),X===n.INT&&(et=n.RGBA32I)),S===n.RGB&&(X===n.UNSIGNED_SHORT&&vt&&(et=vt.RGB16_EXT),X===n.SHORT&&vt&&(et=vt.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(et=n.R11F_G11F_B10F)),S===n.RGBA){let nt=_t?aa:me.getTransfer(ot);X===n.FLOAT&&(et=n.RGBA32F),X===n.HALF_FLOAT&&(et=n.RGBA16F),X===n.UNSIGNED_BYTE&&(et=nt===Ee?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&vt&&(et=vt.RGBA16_EXT),X===n.SHORT&&vt&&(et=vt.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function _(C,S){let X;return C?S===null||S===Dn||S===gr?X=n.DEPTH24_STENCIL8:S===$i?X=n.DEPTH32F_STENCIL8:S===bo&&(X=n.DEPTH24_STENCIL8,Yt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Dn||S===gr?X=n.DEPTH_COMPONENT24:S===$i?X=n.DEPTH_COMPONENT32F:S===bo&&(X=n.DEPTH_COMPONENT16),X}function E(C,S){return T(C)===!0||C.isFramebufferTexture&&C.minFilter!==pi&&C.minFilter!==Ci?Math.log2(Math.max(S.width,S.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?S.mipmaps.length:1}function k(C){let S=new WeakRef(C);i.get(C).__ref=S,m.add(S),v.register(C,S,S)}function N(C){let S=i.get(C).__ref;S!==void 0&&(m.delete(S),v.unregister(S))}function I(C){G(C.target)}function V(C){D(C.target)}function G(C){C.removeEventListener("dispose",I),N(C),Z(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&d.delete(C)}function D(C){C.removeEventListener("dispose",V),N(C),ct(C)}function H(){for(let C of m){let S=C.deref();S!==void 0&&(S.isRenderTarget===!0?D(S):G(S))}m.clear(),d.clear()}function Z(C){let S=i.get(C);if(S.__webglInit===void 0)return;let X=C.source,ht=f.get(X);if(ht){let ot=ht[S.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&z(C),Object.keys(ht).length===0&&f.delete(X)}i.remove(C)}function z(C){let S=i.get(C);n.deleteTexture(S.__webglTexture);let X=C.source,ht=f.get(X);delete ht[S.__cacheKey],o.memory.textures--}function ct(C){let S=i.get(C);S.__depthDisposeCallback&&S.__depthDisposeCallback();let X=C.depthTexture;if(X&&X.renderTarget===C&&G(X),C.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(S.__webglFramebuffer[ot]))for(let _t=0;_t<S.__webglFramebuffer[ot].length;_t++)n.deleteFramebuffer(S.__webglFramebuffer[ot][_t]);else n.deleteFramebuffer(S.__webglFramebuffer[ot]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[ot])}else{if(Array.isArray(S.__webglFramebuffer))for(let ot=0;ot<S.__webglFramebuffer.length;ot++)n.deleteFramebuffer(S.__webglFramebuffer[ot]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ot=0;ot<S.__webglColorRenderbuffer.length;ot++)S.__webglColorRenderbuffer[ot]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[ot]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ht=C.textures;for(let ot=0,_t=ht.length;ot<_t;ot++){let vt=i.get(ht[ot]);vt.__webglTexture&&(n.deleteTexture(vt.__webglTexture),o.memory.textures--),i.remove(ht[ot])}i.remove(C)}let K=0;function Q(){K=0}function st(){return K}function dt(C){K=C}function ut(){let C=K;return C>=s.maxTextures&&Yt("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,C}function tt(C){let S=[];return S.push(C.wrapS),S.push(C.wrapT),S.push(C.wrapR||0),S.push(C.magFilter),S.push(C.minFilter),S.push(C.anisotropy),S.push(C.internalFormat),S.push(C.format),S.push(C.type),S.push(C.generateMipmaps),S.push(C.mipmapsAutoUpdate),S.push(C.premultiplyAlpha),S.push(C.flipY),S.push(C.unpackAlignment),S.push(C.colorSpace),S.join()}function mt(C,S){let X=i.get(C);if(C.isVideoTexture&&Ie(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&X.__version!==C.version){let ht=C.image;if(ht===null)Yt("WebGLRenderer: Texture marked for update but no image data found.");else if(ht.complete===!1)Yt("WebGLRenderer: Texture marked for update but image is incomplete");else{De(X,C,S);return}}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+S)}function xt(C,S){let X=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){De(X,C,S);return}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+S)}function At(C,S){let X=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){De(X,C,S);return}e.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+S)}function St(C,S){let X=i.get(C);if(C.version>0&&X.__version!==C.version){ri(X,C,S);return}e.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+S)}let Gt={[Mc]:n.REPEAT,[qn]:n.CLAMP_TO_EDGE,[Sc]:n.MIRRORED_REPEAT},ie={[pi]:n.NEAREST,[Jg]:n.NEAREST_MIPMAP_NEAREST,[Sa]:n.NEAREST_MIPMAP_LINEAR,[Ci]:n.LINEAR,[Zc]:n.LINEAR_MIPMAP_NEAREST,[vs]:n.LINEAR_MIPMAP_LINEAR},Vt={[e0]:n.NEVER,[Qd]:n.ALWAYS,[i0]:n.LESS,[Jd]:n.LEQUAL,[n0]:n.EQUAL,[jd]:n.GEQUAL,[s0]:n.GREATER,[r0]:n.NOTEQUAL};function le(C,S){if(S.type===$i&&t.has("OES_texture_float_linear")===!1&&(S.magFilter===Ci||S.magFilter===Zc||S.magFilter===Sa||S.magFilter===vs||S.minFilter===Ci||S.minFilter===Zc||S.minFilter===Sa||S.minFilter===vs)&&Yt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(C,n.TEXTURE_WRAP_S,Gt[S.wrapS]),n.texParameteri(C,n.TEXTURE_WRAP_T,Gt[S.wrapT]),(C===n.TEXTURE_3D||C===n.TEXTURE_2D_ARRAY)&&n.texParameteri(C,n.TEXTURE_WRAP_R,Gt[S.wrapR]),n.texParameteri(C,n.TEXTURE_MAG_FILTER,ie[S.magFilter]),n.texParameteri(C,n.TEXTURE_MIN_FILTER,ie[S.minFilter]),S.compareFunction&&(n.texParameteri(C,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(C,n.TEXTURE_COMPARE_FUNC,Vt[S.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===pi||S.minFilter!==Sa&&S.minFilter!==vs||S.type===$i&&t.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let X=t.get("EXT_texture_filter_anisotropic");n.texParameterf(C,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function re(C,S){let X=!1;C.__webglInit===void 0&&(C.__webglInit=!0,S.addEventListener("dispose",I),k(S));let ht=S.source,ot=f.get(ht);ot===void 0&&(ot={},f.set(ht,ot));let _t=tt(S);if(_t!==C.__cacheKey){ot[_t]===void 0&&(ot[_t]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),ot[_t].usedTimes++;let vt=ot[C.__cacheKey];vt!==void 0&&(ot[C.__cacheKey].usedTimes--,vt.usedTimes===0&&z(S)),C.__cacheKey=_t,C.__webglTexture=ot[_t].texture}return X}function te(C,S,X){return Math.floor(Math.floor(C/X)/S)}function We(C,S,X,ht){let _t=C.updateRanges;if(_t.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,X,ht,S.data);else{_t.sort((F,rt)=>F.start-rt.start);let vt=0;for(let F=1;F<_t.length;F++){let rt=_t[vt],it=_t[F],wt=rt.start+rt.count,gt=te(it.start,S.width,4),Mt=te(rt.start,S.width,4);it.start<=wt+1&&gt===Mt&&te(it.start+it.count-1,S.width,4)===gt?rt.count=Math.max(rt.count,it.start+it.count-rt.start):(++vt,_t[vt]=it)}_t.length=vt+1;let et=e.getParameter(n.UNPACK_ROW_LENGTH),nt=e.getParameter(n.UNPACK_SKIP_PIXELS),pt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let F=0,rt=_t.length;F<rt;F++){let it=_t[F],wt=Math.floor(it.start/4),gt=Math.ceil(it.count/4),Mt=wt%S.width,Ht=Math.floor(wt/S.width),Zt=gt,lt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Mt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Ht),e.texSubImage2D(n.TEXTURE_2D,0,Mt,Ht,Zt,lt,X,ht,S.data)}C.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,et),e.pixelStorei(n.UNPACK_SKIP_PIXELS,nt),e.pixelStorei(n.UNPACK_SKIP_ROWS,pt)}}function De(C,S,X){let ht=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ht=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ht=n.TEXTURE_3D);let ot=re(C,S),_t=S.source;e.bindTexture(ht,C.__webglTexture,n.TEXTURE0+X);let vt=i.get(_t);if(_t.version!==vt.__version||ot===!0){if(e.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let lt=me.getPrimaries(me.workingColorSpace),Ot=S.colorSpace===Ms?null:me.getPrimaries(S.colorSpace),Kt=S.colorSpace===Ms||lt===Ot?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Kt)}e.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let nt=y(S.image,!1,s.maxTextureSize);nt=zt(S,nt);let pt=r.convert(S.format,S.colorSpace),F=r.convert(S.type),rt=A(S.internalFormat,pt,F,S.normalized,S.colorSpace,S.isVideoTexture);le(ht,S);let it,wt=S.mipmaps,gt=S.isVideoTexture!==!0,Mt=vt.__version===void 0||ot===!0,Ht=_t.dataReady,Zt=E(S,nt);if(S.isDepthTexture)rt=_(S.format===ys,S.type),Mt&&(gt?e.texStorage2D(n.TEXTURE_2D,1,rt,nt.width,nt.height):e.texImage2D(n.TEXTURE_2D,0,rt,nt.width,nt.height,0,pt,F,null));else if(S.isDataTexture)if(wt.length>0){gt&&Mt&&e.texStorage2D(n.TEXTURE_2D,Zt,rt,wt[0].width,wt[0].height);for(let lt=0,Ot=wt.length;lt<Ot;lt++)it=wt[lt],gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,lt,0,0,it.width,it.height,pt,F,it.data):e.texImage2D(n.TEXTURE_2D,lt,rt,it.width,it.height,0,pt,F,it.data);S.generateMipmaps=!1}else gt?(Mt&&e.texStorage2D(n.TEXTURE_2D,Zt,rt,nt.width,nt.height),Ht&&We(S,nt,pt,F)):e.texImage2D(n.TEXTURE_2D,0,rt,nt.width,nt.height,0,pt,F,nt.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){gt&&Mt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Zt,rt,wt[0].width,wt[0].height,nt.depth);for(let lt=0,Ot=wt.length;lt<Ot;lt++)if(it=wt[lt],S.format!==qi)if(pt!==null)if(gt){if(Ht)if(S.layerUpdates.size>0){let Kt=of(it.width,it.height,S.format,S.type);for(let Rt of S.layerUpdates){let se=it.data.subarray(Rt*Kt/it.data.BYTES_PER_ELEMENT,(Rt+1)*Kt/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,lt,0,0,Rt,it.width,it.height,1,pt,se)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,lt,0,0,0,it.width,it.height,nt.depth,pt,it.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,lt,rt,it.width,it.height,nt.depth,0,it.data,0,0);else Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else gt?Ht&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,lt,0,0,0,it.width,it.height,nt.depth,pt,F,it.data):e.texImage3D(n.TEXTURE_2D_ARRAY,lt,rt,it.width,it.height,nt.depth,0,pt,F,it.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{gt&&Mt&&e.texStorage2D(n.TEXTURE_2D,Zt,rt,wt[0].width,wt[0].height);for(let lt=0,Ot=wt.length;lt<Ot;lt++)it=wt[lt],S.format!==qi?pt!==null?gt?Ht&&e.compressedTexSubImage2D(n.TEXTURE_2D,lt,0,0,it.width,it.height,pt,it.data):e.compressedTexImage2D(n.TEXTURE_2D,lt,rt,it.width,it.height,0,it.data):Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,lt,0,0,it.width,it.height,pt,F,it.data):e.texImage2D(n.TEXTURE_2D,lt,rt,it.width,it.height,0,pt,F,it.data)}else if(S.isDataArrayTexture)if(gt){if(Mt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Zt,rt,nt.width,nt.height,nt.depth),Ht)if(S.layerUpdates.size>0){let lt=of(nt.width,nt.height,S.format,S.type);for(let Ot of S.layerUpdates){let Kt=nt.data.subarray(Ot*lt/nt.data.BYTES_PER_ELEMENT,(Ot+1)*lt/nt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ot,nt.width,nt.height,1,pt,F,Kt)}S.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,nt.width,nt.height,nt.depth,pt,F,nt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,nt.width,nt.height,nt.depth,0,pt,F,nt.data);else if(S.isData3DTexture)gt?(Mt&&e.texStorage3D(n.TEXTURE_3D,Zt,rt,nt.width,nt.height,nt.depth),Ht&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,nt.width,nt.height,nt.depth,pt,F,nt.data)):e.texImage3D(n.TEXTURE_3D,0,rt,nt.width,nt.height,nt.depth,0,pt,F,nt.data);else if(S.isFramebufferTexture){if(Mt)if(gt)e.texStorage2D(n.TEXTURE_2D,Zt,rt,nt.width,nt.height);else{let lt=nt.width,Ot=nt.height;for(let Kt=0;Kt<Zt;Kt++)e.texImage2D(n.TEXTURE_2D,Kt,rt,lt,Ot,0,pt,F,null),lt>>=1,Ot>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let lt=n.canvas;if(lt.hasAttribute("layoutsubtree")||lt.setAttribute("layoutsubtree","true"),nt.parentNode!==lt){lt.appendChild(nt),d.add(S),lt.onpaint=Ot=>{let Kt=Ot.changedElements;for(let Rt of d)Kt.includes(Rt.image)&&(Rt.needsUpdate=!0)},lt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,nt);else{let Kt=n.RGBA,Rt=n.RGBA,se=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Kt,Rt,se,nt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(wt.length>0){if(gt&&Mt){let lt=Xt(wt[0]);e.texStorage2D(n.TEXTURE_2D,Zt,rt,lt.width,lt.height)}for(let lt=0,Ot=wt.length;lt<Ot;lt++)it=wt[lt],gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,lt,0,0,pt,F,it):e.texImage2D(n.TEXTURE_2D,lt,rt,pt,F,it);S.generateMipmaps=!1}else if(gt){if(Mt){let lt=Xt(nt);e.texStorage2D(n.TEXTURE_2D,Zt,rt,lt.width,lt.height)}Ht&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,pt,F,nt)}else e.texImage2D(n.TEXTURE_2D,0,rt,pt,F,nt);T(S)&&S.mipmapsAutoUpdate===!0&&M(ht),vt.__version=_t.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function ri(C,S,X){if(S.image.length!==6)return;let ht=re(C,S),ot=S.source;e.bindTexture(n.TEXTURE_CUBE_MAP,C.__webglTexture,n.TEXTURE0+X);let _t=i.get(ot);if(ot.version!==_t.__version||ht===!0){e.activeTexture(n.TEXTURE0+X);let vt=me.getPrimaries(me.workingColorSpace),et=S.colorSpace===Ms?null:me.getPrimaries(S.colorSpace),nt=S.colorSpace===Ms||vt===et?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt);let pt=S.isCompressedTexture||S.image[0].isCompressedTexture,F=S.image[0]&&S.image[0].isDataTexture,rt=[];for(let Rt=0;Rt<6;Rt++)!pt&&!F?rt[Rt]=y(S.image[Rt],!0,s.maxCubemapSize):rt[Rt]=F?S.image[Rt].image:S.image[Rt],rt[Rt]=zt(S,rt[Rt]);let it=rt[0],wt=r.convert(S.format,S.colorSpace),gt=r.convert(S.type),Mt=A(S.internalFormat,wt,gt,S.normalized,S.colorSpace),Ht=S.isVideoTexture!==!0,Zt=_t.__version===void 0||ht===!0,lt=ot.dataReady,Ot=E(S,it);le(n.TEXTURE_CUBE_MAP,S);let Kt;if(S.isDepthTexture){if(Mt=_(S.format===ys,S.type),Zt)if(Ht)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Mt,it.width,it.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,it.width,it.height,0,wt,gt,null)}else if(pt){Ht&&Zt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ot,Mt,it.width,it.height);for(let Rt=0;Rt<6;Rt++){Kt=rt[Rt].mipmaps;for(let se=0;se<Kt.length;se++){let Oe=Kt[se];S.format!==qi?wt!==null?Ht?lt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se,0,0,Oe.width,Oe.height,wt,Oe.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se,Mt,Oe.width,Oe.height,0,Oe.data):Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ht?lt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se,0,0,Oe.width,Oe.height,wt,gt,Oe.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se,Mt,Oe.width,Oe.height,0,wt,gt,Oe.data)}}}else{if(Kt=S.mipmaps,Ht&&Zt){Kt.length>0&&Ot++;let Rt=Xt(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ot,Mt,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(F){Ht?lt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,rt[Rt].width,rt[Rt].height,wt,gt,rt[Rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,rt[Rt].width,rt[Rt].height,0,wt,gt,rt[Rt].data);for(let se=0;se<Kt.length;se++){let ki=Kt[se].image[Rt].image;Ht?lt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se+1,0,0,ki.width,ki.height,wt,gt,ki.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se+1,Mt,ki.width,ki.height,0,wt,gt,ki.data)}}else{Ht?lt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,wt,gt,rt[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,wt,gt,rt[Rt]);for(let se=0;se<Kt.length;se++){let Oe=Kt[se];Ht?lt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se+1,0,0,wt,gt,Oe.image[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se+1,Mt,wt,gt,Oe.image[Rt])}}}T(S)&&S.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),_t.__version=ot.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function Ce(C,S,X,ht,ot,_t){let vt=r.convert(X.format,X.colorSpace),et=r.convert(X.type),nt=A(X.internalFormat,vt,et,X.normalized,X.colorSpace),pt=i.get(S),F=i.get(X);if(F.__renderTarget=S,!pt.__hasExternalTextures){let rt=Math.max(1,S.width>>_t),it=Math.max(1,S.height>>_t);ot===n.TEXTURE_3D||ot===n.TEXTURE_2D_ARRAY?e.texImage3D(ot,_t,nt,rt,it,S.depth,0,vt,et,null):e.texImage2D(ot,_t,nt,rt,it,0,vt,et,null)}e.bindFramebuffer(n.FRAMEBUFFER,C),bt(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ht,ot,F.__webglTexture,0,ne(S)):(ot===n.TEXTURE_2D||ot>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ht,ot,F.__webglTexture,_t),e.bindFramebuffer(n.FRAMEBUFFER,null)}function bi(C,S,X){if(n.bindRenderbuffer(n.RENDERBUFFER,C),S.depthBuffer){let ht=S.depthTexture,ot=ht&&ht.isDepthTexture?ht.type:null,_t=_(S.stencilBuffer,ot),vt=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;bt(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ne(S),_t,S.width,S.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,ne(S),_t,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,_t,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,vt,n.RENDERBUFFER,C)}else{let ht=S.textures;for(let ot=0;ot<ht.length;ot++){let _t=ht[ot],vt=r.convert(_t.format,_t.colorSpace),et=r.convert(_t.type),nt=A(_t.internalFormat,vt,et,_t.normalized,_t.colorSpace);bt(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ne(S),nt,S.width,S.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,ne(S),nt,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,nt,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ve(C,S,X){let ht=S.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,C),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=i.get(S.depthTexture);ot.__renderTarget=S;let _t=ht?S.depthTexture.image[0]:S.depthTexture.image;(!ot.__webglTexture||_t.width!==S.width||_t.height!==S.height)&&(_t.width=S.width,_t.height=S.height,S.depthTexture.needsUpdate=!0),ht?St(S.depthTexture,0):mt(S.depthTexture,0);let vt=ot.__webglTexture,et=ne(S),nt=ht?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,pt=S.depthTexture.format===ys?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===ms)bt(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,nt,vt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,pt,nt,vt,0);else if(S.depthTexture.format===ys)bt(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,nt,vt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,pt,nt,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function gi(C){let S=i.get(C),X=C.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==C.depthTexture){let ht=C.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ht){let ot=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ht.removeEventListener("dispose",ot)};ht.addEventListener("dispose",ot),S.__depthDisposeCallback=ot}S.__boundDepthTexture=ht}if(C.depthTexture&&!S.__autoAllocateDepthBuffer)if(X)for(let ht=0;ht<6;ht++)ve(S.__webglFramebuffer[ht],C,ht);else C.texture.mipmaps.length>0?ve(S.__webglFramebuffer[0],C,0):ve(S.__webglFramebuffer,C,0);else if(X){S.__webglDepthbuffer=[];for(let ht=0;ht<6;ht++)if(e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[ht]),S.__webglDepthbuffer[ht]===void 0)S.__webglDepthbuffer[ht]=n.createRenderbuffer(),bi(S.__webglDepthbuffer[ht],C,!1);else{let ot=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=S.__webglDepthbuffer[ht];n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,_t)}}else if(C.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),bi(S.__webglDepthbuffer,C,!1);else{let ot=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,_t)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ke(C,S,X){let ht=i.get(C);S!==void 0&&Ce(ht.__webglFramebuffer,C,C.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&gi(C)}function oi(C){let S=C.texture,X=i.get(C),ht=i.get(S);C.addEventListener("dispose",V),k(C);let ot=C.textures,_t=C.isWebGLCubeRenderTarget===!0,vt=ot.length>1;if(vt||(ht.__webglTexture===void 0&&(ht.__webglTexture=n.createTexture()),ht.__version=S.version,o.memory.textures++),_t){X.__webglFramebuffer=[];for(let et=0;et<6;et++)if(S.mipmaps.length>0){X.__webglFramebuffer[et]=[];for(let nt=0;nt<S.mipmaps.length;nt++)X.__webglFramebuffer[et][nt]=n.createFramebuffer()}else X.__webglFramebuffer[et]=n.createFramebuffer()}else{if(S.mipmaps.length>0){X.__webglFramebuffer=[];for(let et=0;et<S.mipmaps.length;et++)X.__webglFramebuffer[et]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(vt)for(let et=0,nt=ot.length;et<nt;et++){let pt=i.get(ot[et]);pt.__webglTexture===void 0&&(pt.__webglTexture=n.createTexture(),o.memory.textures++)}if(C.samples>0&&bt(C)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let et=0;et<ot.length;et++){let nt=ot[et];X.__webglColorRenderbuffer[et]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[et]);let pt=r.convert(nt.format,nt.colorSpace),F=r.convert(nt.type),rt=A(nt.internalFormat,pt,F,nt.normalized,nt.colorSpace,C.isXRRenderTarget===!0),it=ne(C);n.renderbufferStorageMultisample(n.RENDERBUFFER,it,rt,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+et,n.RENDERBUFFER,X.__webglColorRenderbuffer[et])}n.bindRenderbuffer(n.RENDERBUFFER,null),C.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),bi(X.__webglDepthRenderbuffer,C,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_t){e.bindTexture(n.TEXTURE_CUBE_MAP,ht.__webglTexture),le(n.TEXTURE_CUBE_MAP,S);for(let et=0;et<6;et++)if(S.mipmaps.length>0)for(let nt=0;nt<S.mipmaps.length;nt++)Ce(X.__webglFramebuffer[et][nt],C,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,nt);else Ce(X.__webglFramebuffer[et],C,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);T(S)?M(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let et=0,nt=ot.length;et<nt;et++){let pt=ot[et],F=i.get(pt),rt=n.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(rt=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,F.__webglTexture),le(rt,pt),Ce(X.__webglFramebuffer,C,pt,n.COLOR_ATTACHMENT0+et,rt,0),T(pt)&&M(rt)}e.unbindTexture()}else{let et=n.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(et=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(et,ht.__webglTexture),le(et,S),S.mipmaps.length>0)for(let nt=0;nt<S.mipmaps.length;nt++)Ce(X.__webglFramebuffer[nt],C,S,n.COLOR_ATTACHMENT0,et,nt);else Ce(X.__webglFramebuffer,C,S,n.COLOR_ATTACHMENT0,et,0);T(S)?M(et):S.mipmaps.length>0&&n.texParameteri(et,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}C.depthBuffer&&gi(C)}function U(C){let S=C.textures;for(let X=0,ht=S.length;X<ht;X++){let ot=S[X];if(T(ot)&&ot.mipmapsAutoUpdate===!0){let _t=R(C),vt=i.get(ot).__webglTexture;e.bindTexture(_t,vt),M(_t),e.unbindTexture()}}}let Ct=[];function $t(C){if(C.samples>0){if(bt(C)===!1){let S=C.textures,X=C.width,ht=C.height,ot=n.COLOR_BUFFER_BIT,_t=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=i.get(C),et=S.length>1;if(et)for(let pt=0;pt<S.length;pt++)e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let pt=0;pt<S.length;pt++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(ot|=n.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(ot|=n.STENCIL_BUFFER_BIT)),et){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,vt.__webglColorRenderbuffer[pt]);let F=i.get(S[pt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,X,ht,0,0,X,ht,ot,n.NEAREST),l===!0&&(Ct.length=0,Ct.push(n.COLOR_ATTACHMENT0+pt),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Ct.push(_t),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ct))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),et)for(let pt=0;pt<S.length;pt++){e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,vt.__webglColorRenderbuffer[pt]);let F=i.get(S[pt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,F,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let S=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function ne(C){return Math.min(s.maxSamples,C.samples)}function bt(C){let S=i.get(C);return C.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Ie(C){let S=o.render.frame;h.get(C)!==S&&(h.set(C,S),C.update())}function zt(C,S){let X=C.colorSpace,ht=C.format,ot=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||X!==Us&&X!==Ms&&(me.getTransfer(X)===Ee?(ht!==qi||ot!==dn)&&Yt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):jt("WebGLTextures: Unsupported texture color space:",X)),S}function Xt(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=ut,this.resetTextureUnits=Q,this.getTextureUnits=st,this.setTextureUnits=dt,this.setTexture2D=mt,this.setTexture2DArray=xt,this.setTexture3D=At,this.setTextureCube=St,this.rebindTextures=Ke,this.setupRenderTarget=oi,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=$t,this.setupDepthRenderbuffer=gi,this.setupFrameBufferTexture=Ce,this.useMultisampledRTT=bt,this.dispose=H}function VE(n,t){function e(i,s=Ms){let r,o=me.getTransfer(s);if(i===dn)return n.UNSIGNED_BYTE;if(i===Jc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===jc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Xd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===$d)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Gd)return n.BYTE;if(i===Wd)return n.SHORT;if(i===bo)return n.UNSIGNED_SHORT;if(i===Kc)return n.INT;if(i===Dn)return n.UNSIGNED_INT;if(i===$i)return n.FLOAT;if(i===Fn)return n.HALF_FLOAT;if(i===qd)return n.ALPHA;if(i===Yd)return n.RGB;if(i===qi)return n.RGBA;if(i===ms)return n.DEPTH_COMPONENT;if(i===ys)return n.DEPTH_STENCIL;if(i===Zd)return n.RED;if(i===Qc)return n.RED_INTEGER;if(i===Ws)return n.RG;if(i===th)return n.RG_INTEGER;if(i===eh)return n.RGBA_INTEGER;if(i===ba||i===wa||i===Ea||i===Ta)if(o===Ee)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ba)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ea)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ta)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ba)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===wa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ea)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ta)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ih||i===nh||i===sh||i===rh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===ih)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===nh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===sh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===rh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===oh||i===ah||i===lh||i===ch||i===hh||i===Aa||i===uh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===oh||i===ah)return o===Ee?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===lh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===ch)return r.COMPRESSED_R11_EAC;if(i===hh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Aa)return r.COMPRESSED_RG11_EAC;if(i===uh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===dh||i===fh||i===ph||i===mh||i===gh||i===_h||i===xh||i===vh||i===yh||i===Mh||i===Sh||i===bh||i===wh||i===Eh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===dh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===fh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ph)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===mh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===gh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===_h)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===xh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===vh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===yh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Mh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Sh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===bh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===wh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Eh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Th||i===Ah||i===Rh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Th)return o===Ee?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Ah)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Rh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Ch||i===Ph||i===Ra||i===Ih)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Ch)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Ph)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ra)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Ih)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===gr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var HE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,GE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,mf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new _a(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Kn({vertexShader:HE,fragmentShader:GE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new yi(new xa(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},gf=class extends Yn{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,m=null,v=typeof XRWebGLBinding<"u",g=new mf,p={},y=e.getContextAttributes(),T=null,M=null,R=[],A=[],_=new ge,E=null,k=null,N=new cn;N.viewport=new Ze;let I=new cn;I.viewport=new Ze;let V=[N,I],G=new Wc,D=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let mt=R[tt];return mt===void 0&&(mt=new go,R[tt]=mt),mt.getTargetRaySpace()},this.getControllerGrip=function(tt){let mt=R[tt];return mt===void 0&&(mt=new go,R[tt]=mt),mt.getGripSpace()},this.getHand=function(tt){let mt=R[tt];return mt===void 0&&(mt=new go,R[tt]=mt),mt.getHandSpace()};function Z(tt){let mt=A.indexOf(tt.inputSource);if(mt===-1)return;let xt=R[mt];xt!==void 0&&(xt.update(tt.inputSource,tt.frame,c||o),xt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function z(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",ct);for(let tt=0;tt<R.length;tt++){let mt=A[tt];mt!==null&&(A[tt]=null,R[tt].disconnect(mt))}D=null,H=null,g.reset();for(let tt in p)delete p[tt];if(t.setRenderTarget(T),f=null,u=null,d=null,s=null,M=null,ut.stop(),i.isPresenting=!1,t.setPixelRatio(E),t.setSize(_.width,_.height,!1),k!==null){let tt=k.camera;tt.fov=k.fov,tt.zoom=k.zoom,tt.updateProjectionMatrix(),k=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&Yt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&Yt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&v&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(T=t.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",z),s.addEventListener("inputsourceschange",ct),y.xrCompatible!==!0&&await e.makeXRCompatible(),E=t.getPixelRatio(),t.getSize(_),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,At=null,St=null;y.depth&&(St=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=y.stencil?ys:ms,At=y.stencil?gr:Dn);let Gt={colorFormat:e.RGBA8,depthFormat:St,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Gt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),M=new Wi(u.textureWidth,u.textureHeight,{format:qi,type:dn,depthTexture:new _s(u.textureWidth,u.textureHeight,At,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let xt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new Wi(f.framebufferWidth,f.framebufferHeight,{format:qi,type:dn,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ut.setContext(s),ut.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ct(tt){for(let mt=0;mt<tt.removed.length;mt++){let xt=tt.removed[mt],At=A.indexOf(xt);At>=0&&(A[At]=null,R[At].disconnect(xt))}for(let mt=0;mt<tt.added.length;mt++){let xt=tt.added[mt],At=A.indexOf(xt);if(At===-1){for(let Gt=0;Gt<R.length;Gt++)if(Gt>=A.length){A.push(xt),At=Gt;break}else if(A[Gt]===null){A[Gt]=xt,At=Gt;break}if(At===-1)break}let St=R[At];St&&St.connect(xt)}}function K(tt,mt){mt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(mt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let mt=tt.near,xt=tt.far;g.texture!==null&&(g.depthNear>0&&(mt=g.depthNear),g.depthFar>0&&(xt=g.depthFar)),G.near=I.near=N.near=mt,G.far=I.far=N.far=xt,(D!==G.near||H!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),D=G.near,H=G.far),G.layers.mask=tt.layers.mask|6,N.layers.mask=G.layers.mask&-5,I.layers.mask=G.layers.mask&-3;let At=tt.parent,St=G.cameras;K(G,At);for(let Gt=0;Gt<St.length;Gt++)K(St[Gt],At);G.projectionMatrix.copy(N.projectionMatrix),G.projectionMatrixInverse.copy(N.projectionMatrixInverse),k===null&&tt.isPerspectiveCamera&&(k={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,G,At)};function Q(tt,mt,xt){xt===null?tt.matrix.copy(mt.matrixWorld):(tt.matrix.copy(xt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(mt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(mt.projectionMatrix),tt.projectionMatrixInverse.copy(mt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=wc*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(tt){l=tt,u!==null&&(u.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(G)},this.getCameraTexture=function(tt){return p[tt]};let st=null;function dt(tt,mt){if(h=mt.getViewerPose(c||o),m=mt,h!==null){let xt=h.views;f!==null&&(t.setRenderTargetFramebuffer(M,f.framebuffer),t.setRenderTarget(M));let At=!1;xt.length!==G.cameras.length&&(G.cameras.length=0,At=!0);for(let Vt=0;Vt<xt.length;Vt++){let le=xt[Vt],re=null;if(f!==null)re=f.getViewport(le);else{let We=d.getViewSubImage(u,le);re=We.viewport,Vt===0&&(t.setRenderTargetTextures(M,We.colorTexture,We.depthStencilTexture),t.setRenderTarget(M))}let te=V[Vt];te===void 0&&(te=new cn,te.layers.enable(Vt),te.viewport=new Ze,V[Vt]=te),te.matrix.fromArray(le.transform.matrix),te.matrix.decompose(te.position,te.quaternion,te.scale),te.projectionMatrix.fromArray(le.projectionMatrix),te.projectionMatrixInverse.copy(te.projectionMatrix).invert(),te.viewport.set(re.x,re.y,re.width,re.height),Vt===0&&(G.matrix.copy(te.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),At===!0&&G.cameras.push(te)}let St=s.enabledFeatures;if(St&&St.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){d=i.getBinding();let Vt=d.getDepthInformation(xt[0]);Vt&&Vt.isValid&&Vt.texture&&g.init(Vt,s.renderState)}if(St&&St.includes("camera-access")&&v){t.state.unbindTexture(),d=i.getBinding();for(let Vt=0;Vt<xt.length;Vt++){let le=xt[Vt].camera;if(le){let re=p[le];re||(re=new _a,p[le]=re);let te=d.getCameraImage(le);re.sourceTexture=te}}}}for(let xt=0;xt<R.length;xt++){let At=A[xt],St=R[xt];At!==null&&St!==void 0&&St.update(At,mt,c||o)}st&&st(tt,mt),mt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:mt}),m=null}let ut=new O0;ut.setAnimationLoop(dt),this.setAnimationLoop=function(tt){st=tt},this.dispose=function(){}}},WE=new Ue,q0=new Qt;q0.set(-1,0,0,0,1,0,0,0,1);function XE(n,t){function e(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function i(g,p){p.color.getRGB(g.fogColor.value,nf(n)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function s(g,p,y,T,M){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(g,p):p.isMeshLambertMaterial?(r(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(g,p),d(g,p)):p.isMeshPhongMaterial?(r(g,p),h(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(g,p),u(g,p),p.isMeshPhysicalMaterial&&f(g,p,M)):p.isMeshMatcapMaterial?(r(g,p),m(g,p)):p.isMeshDepthMaterial?r(g,p):p.isMeshDistanceMaterial?(r(g,p),v(g,p)):p.isMeshNormalMaterial?r(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,y,T):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,e(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===Xi&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,e(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===Xi&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,e(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,e(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let y=t.get(p),T=y.envMap,M=y.envMapRotation;T&&(g.envMap.value=T,g.envMapRotation.value.setFromMatrix4(WE.makeRotationFromEuler(M)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(q0),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,y,T){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*y,g.scale.value=T*.5,p.map&&(g.map.value=p.map,e(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function h(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function d(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function u(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function f(g,p,y){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Xi&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function v(g,p){let y=t.get(p).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function $E(n,t,e,i){let s={},r={};function o(y,T){let M=T.program;i.uniformBlockBinding(y,M,s[y.id])}function a(y,T){let M=s[y.id];M===void 0&&(m(y),M=l(y),s[y.id]=M,y.addEventListener("dispose",g));let R=T.program;i.updateUBOMapping(y,R);let A=t.render.frame;r[y.id]!==A&&(c(y),r[y.id]=A)}function l(y){let T=n.createBuffer(),M=y.__size,R=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,M,R),n.bindBuffer(n.UNIFORM_BUFFER,null),T}function c(y){let T=s[y.id],M=y.uniforms,R=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let A=0,_=M.length;A<_;A++){let E=M[A];if(Array.isArray(E))for(let k=0,N=E.length;k<N;k++)h(E[k],A,k,R);else h(E,A,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(y,T,M,R){if(u(y,T,M,R)===!0){let A=y.__offset,_=y.value;if(Array.isArray(_)){let E=0;for(let k=0;k<_.length;k++){let N=_[k],I=v(N,!0);d(N,y.__data,E),E+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,y.__data)}}function d(y,T,M){typeof y=="number"||typeof y=="boolean"?T[M]=y:y.isMatrix3?(T[M]=y.elements[0],T[M+1]=y.elements[1],T[M+2]=y.elements[2],T[M+3]=0,T[M+4]=y.elements[3],T[M+5]=y.elements[4],T[M+6]=y.elements[5],T[M+7]=0,T[M+8]=y.elements[6],T[M+9]=y.elements[7],T[M+10]=y.elements[8],T[M+11]=0):ArrayBuffer.isView(y)?T.set(y.subarray(0,T.length-M),M):y.toArray(T,M)}function u(y,T,M,R){let A=y.value,_=T+"_"+M;if(Array.isArray(A)){R[_]===void 0&&(R[_]=[]);let E=R[_],k=!1;for(let N=0;N<A.length;N++)f(A[N],E,N)===!0&&(k=!0);return k}return f(A,R,_)}function f(y,T,M){if(T[M]===void 0)return typeof y=="number"||typeof y=="boolean"?T[M]=y:ArrayBuffer.isView(y)?T[M]=y.slice():T[M]=y.clone(),!0;{let R=T[M];if(typeof y=="number"||typeof y=="boolean"){if(R!==y)return T[M]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(R.equals(y)===!1)return R.copy(y),!0}}return!1}function m(y){let T=y.uniforms,M=0,R=16;for(let _=0,E=T.length;_<E;_++){let k=Array.isArray(T[_])?T[_]:[T[_]];for(let N=0,I=k.length;N<I;N++){let V=k[N],G=Array.isArray(V.value)?V.value:[V.value],D=Array.isArray(T[_])||Array.isArray(V.value),H=M;for(let z=0,ct=G.length;z<ct;z++){let K=G[z],Q=v(K,D),st=M%R,dt=st%Q.boundary,ut=st+dt;M+=dt,ut!==0&&R-ut<Q.storage&&(M+=R-ut),z===0&&(H=M),M+=Q.storage}let Z=V.type==="int"?Int32Array:V.type==="uint"?Uint32Array:Float32Array;V.__data=new Z((M-H)/Float32Array.BYTES_PER_ELEMENT),V.__offset=H}}let A=M%R;return A>0&&(M+=R-A),y.__size=M,y.__cache={},this}function v(y,T){let M={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(M.boundary=4,M.storage=4):y.isVector2?(M.boundary=8,M.storage=8):y.isVector3||y.isColor?(M.boundary=16,M.storage=12):y.isVector4?(M.boundary=16,M.storage=16):y.isMatrix3?(M.boundary=16,M.storage=48):y.isMatrix4?(M.boundary=16,M.storage=64):y.isTexture?Yt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(M.boundary=16,M.storage=y.byteLength):Yt("WebGLRenderer: Unsupported uniform value type.",y),T===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function g(y){let T=y.target;T.removeEventListener("dispose",g),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:p}}var qE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),jn=null;function YE(){return jn===null&&(jn=new gs(qE,16,16,Ws,Fn),jn.name="DFG_LUT",jn.minFilter=Ci,jn.magFilter=Ci,jn.wrapS=qn,jn.wrapT=qn,jn.generateMipmaps=!1,jn.needsUpdate=!0),jn}var Fh=class{constructor(t={}){let{canvas:e=a0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=dn}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let v=f,g=new Set([eh,th,Qc]),p=new Set([dn,Dn,bo,gr,Jc,jc]),y=new Uint32Array(4),T=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},R=null,A=null,_=[],E=[],k=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Jn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,I=!1,V=null,G=null,D=null,H=null;this._outputColorSpace=ln;let Z=0,z=0,ct=null,K=-1,Q=null,st=new Ze,dt=new Ze,ut=null,tt=new _e(0),mt=0,xt=e.width,At=e.height,St=1,Gt=null,ie=null,Vt=new Ze(0,0,xt,At),le=new Ze(0,0,xt,At),re=!1,te=new ur,We=new Cc,De=!1,ri=!1,Ce=new Ue,bi=new J,ve=new Ze,gi={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ke=!1;function oi(){return ct===null?St:1}let U=i;function Ct(w,O){return e.getContext(w,O)}let $t,ne,bt,Ie,zt,Xt,C,S,X,ht,ot,_t,vt,et,nt,pt,F,rt,it,wt,gt,Mt,Ht;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ot,!1),e.addEventListener("webglcontextrestored",Kt,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),U===null){let O="webgl2";if(U=Ct(O,w),U===null)throw Ct(O)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Zt()}catch(w){throw e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),jt("WebGLRenderer: "+w.message),w}function Zt(){$t=new r1(U),$t.init(),gt=new VE(U,$t),ne=new Yw(U,$t,t,gt),bt=new BE(U,$t),ne.reversedDepthBuffer&&u&&bt.buffers.depth.setReversed(!0),G=U.createFramebuffer(),D=U.createFramebuffer(),H=U.createFramebuffer(),Ie=new l1(U),zt=new EE,Xt=new zE(U,$t,bt,zt,ne,gt,Ie),C=new s1(N),S=new hS(U),Mt=new $w(U,S),X=new o1(U,S,Ie,Mt),ht=new h1(U,X,S,Mt,Ie),rt=new c1(U,ne,Xt),nt=new Zw(zt),ot=new wE(N,C,$t,ne,Mt,nt),_t=new XE(N,zt),vt=new AE,et=new NE($t),F=new Xw(N,C,bt,ht,m,l),pt=new kE(N,ht,ne),Ht=new $E(U,Ie,ne,bt),it=new qw(U,$t,Ie),wt=new a1(U,$t,Ie),Ie.programs=ot.programs,N.capabilities=ne,N.extensions=$t,N.properties=zt,N.renderLists=vt,N.shadowMap=pt,N.state=bt,N.info=Ie}v!==dn&&(k=new d1(v,e.width,e.height,a,s,r));let lt=new gf(N,U);this.xr=lt,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let w=$t.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=$t.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return St},this.setPixelRatio=function(w){w!==void 0&&(St=w,this.setSize(xt,At,!1))},this.getSize=function(w){return w.set(xt,At)},this.setSize=function(w,O,j=!0){if(lt.isPresenting){Yt("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=w,At=O,e.width=Math.floor(w*St),e.height=Math.floor(O*St),j===!0&&(e.style.width=w+"px",e.style.height=O+"px"),k!==null&&k.setSize(e.width,e.height),this.setViewport(0,0,w,O)},this.getDrawingBufferSize=function(w){return w.set(xt*St,At*St).floor()},this.setDrawingBufferSize=function(w,O,j){xt=w,At=O,St=j,e.width=Math.floor(w*j),e.height=Math.floor(O*j),this.setViewport(0,0,w,O)},this.setEffects=function(w){if(v===dn){jt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let O=0;O<w.length;O++)if(w[O].isOutputPass===!0){Yt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(st)},this.getViewport=function(w){return w.copy(Vt)},this.setViewport=function(w,O,j,$){w.isVector4?Vt.set(w.x,w.y,w.z,w.w):Vt.set(w,O,j,$),bt.viewport(st.copy(Vt).multiplyScalar(oi()).round())},this.getScissor=function(w){return w.copy(le)},this.setScissor=function(w,O,j,$){w.isVector4?le.set(w.x,w.y,w.z,w.w):le.set(w,O,j,$),bt.scissor(dt.copy(le).multiplyScalar(oi()).round())},this.getScissorTest=function(){return re},this.setScissorTest=function(w){bt.setScissorTest(re=w)},this.setOpaqueSort=function(w){Gt=w},this.setTransparentSort=function(w){ie=w},this.getClearColor=function(w){return w.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(w=!0,O=!0,j=!0){let $=0;if(w){let q=!1;if(ct!==null){let Et=ct.texture.format;q=g.has(Et)}if(q){let Et=ct.texture.type,Pt=p.has(Et),Tt=F.getClearColor(),It=F.getClearAlpha(),Bt=Tt.r,Jt=Tt.g,he=Tt.b;Pt?(y[0]=Bt,y[1]=Jt,y[2]=he,y[3]=It,U.clearBufferuiv(U.COLOR,0,y)):(T[0]=Bt,T[1]=Jt,T[2]=he,T[3]=It,U.clearBufferiv(U.COLOR,0,T))}else $|=U.COLOR_BUFFER_BIT}O&&($|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&U.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),V=w},this.dispose=function(){e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),F.dispose(),vt.dispose(),et.dispose(),Xt.dispose(),zt.dispose(),C.dispose(),ht.dispose(),X.dispose(),Mt.dispose(),Ht.dispose(),ot.dispose(),lt.dispose(),lt.removeEventListener("sessionstart",ka),lt.removeEventListener("sessionend",On),es.stop()};function Ot(w){w.preventDefault(),tf("WebGLRenderer: Context Lost."),I=!0}function Kt(){tf("WebGLRenderer: Context Restored."),I=!1;let w=Ie.autoReset,O=pt.enabled,j=pt.autoUpdate,$=pt.needsUpdate,q=pt.type;Zt(),Ie.autoReset=w,pt.enabled=O,pt.autoUpdate=j,pt.needsUpdate=$,pt.type=q}function Rt(w){jt("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function se(w){let O=w.target;O.removeEventListener("dispose",se),Oe(O)}function Oe(w){ki(w),zt.remove(w)}function ki(w){let O=zt.get(w).programs;O!==void 0&&(O.forEach(function(j){ot.releaseProgram(j)}),w.isShaderMaterial&&ot.releaseShaderCache(w))}this.renderBufferDirect=function(w,O,j,$,q,Et){O===null&&(O=gi);let Pt=q.isMesh&&q.matrixWorld.determinantAffine()<0,Tt=Co(w,O,j,$,q);bt.setMaterial($,Pt);let It=j.index,Bt=1;if($.wireframe===!0){if(It=X.getWireframeAttribute(j),It===void 0)return;Bt=2}let Jt=j.drawRange,he=j.attributes.position,kt=Jt.start*Bt,ue=(Jt.start+Jt.count)*Bt;Et!==null&&(kt=Math.max(kt,Et.start*Bt),ue=Math.min(ue,(Et.start+Et.count)*Bt)),It!==null?(kt=Math.max(kt,0),ue=Math.min(ue,It.count)):he!=null&&(kt=Math.max(kt,0),ue=Math.min(ue,he.count));let qe=ue-kt;if(qe<0||qe===1/0)return;Mt.setup(q,$,Tt,j,It);let Te,Ae=it;if(It!==null&&(Te=S.get(It),Ae=wt,Ae.setIndex(Te)),q.isMesh)$.wireframe===!0?(bt.setLineWidth($.wireframeLinewidth*oi()),Ae.setMode(U.LINES)):Ae.setMode(U.TRIANGLES);else if(q.isLine){let _i=$.linewidth;_i===void 0&&(_i=1),bt.setLineWidth(_i*oi()),q.isLineSegments?Ae.setMode(U.LINES):q.isLineLoop?Ae.setMode(U.LINE_LOOP):Ae.setMode(U.LINE_STRIP)}else q.isPoints?Ae.setMode(U.POINTS):q.isSprite&&Ae.setMode(U.TRIANGLES);if(q.isBatchedMesh)if($t.get("WEBGL_multi_draw"))Ae.renderMultiDraw(q._multiDrawStarts,q._multiDrawCounts,q._multiDrawCount);else{let _i=q._multiDrawStarts,Ft=q._multiDrawCounts,ai=q._multiDrawCount,fe=It?S.get(It).bytesPerElement:1,ns=zt.get($).currentProgram.getUniforms();for(let li=0;li<ai;li++)ns.setValue(U,"_gl_DrawID",li),Ae.render(_i[li]/fe,Ft[li])}else if(q.isInstancedMesh)Ae.renderInstances(kt,qe,q.count);else if(j.isInstancedBufferGeometry){let _i=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ft=Math.min(j.instanceCount,_i);Ae.renderInstances(kt,qe,Ft)}else Ae.render(kt,qe)};function To(w,O,j,$){V!==null&&w.isNodeMaterial&&V.setObject($,w),De===!0&&nt.setState(w,j,!1),w.transparent===!0&&w.side===Mn&&w.forceSinglePass===!1?(w.side=Xi,w.needsUpdate=!0,kn(w,O,$),w.side=Gs,w.needsUpdate=!0,kn(w,O,$),w.side=Mn):kn(w,O,$)}this.compile=function(w,O,j=null){j===null&&(j=w),V!==null&&V.renderStart(w,O,j),A=et.get(j),A.init(O),E.push(A),j.traverseVisible(function(q){q.isLight&&q.layers.test(O.layers)&&(A.pushLight(q),q.castShadow&&A.pushShadow(q))}),w!==j&&w.traverseVisible(function(q){q.isLight&&q.layers.test(O.layers)&&(A.pushLight(q),q.castShadow&&A.pushShadow(q))}),A.setupLights(),V!==null&&V.updateLights(A.state.lightsArray),ri=this.localClippingEnabled,De=nt.init(this.clippingPlanes,ri),De===!0&&nt.setGlobalState(this.clippingPlanes,O),V!==null&&pt.render(A.state.shadowsArray,j,O);let $=new Set;return w.traverse(function(q){if(!(q.isMesh||q.isPoints||q.isLine||q.isSprite))return;let Et=q.material;if(Et)if(Array.isArray(Et))for(let Pt=0;Pt<Et.length;Pt++){let Tt=Et[Pt];To(Tt,j,O,q),$.add(Tt)}else To(Et,j,O,q),$.add(Et)}),A=E.pop(),V!==null&&V.renderEnd(),$},this.compileAsync=function(w,O,j=null){let $=this.compile(w,O,j);return new Promise(q=>{function Et(){if($.forEach(function(Pt){let It=zt.get(Pt).currentProgram;(It===void 0||It.isReady())&&$.delete(Pt)}),$.size===0){q(w);return}setTimeout(Et,10)}$t.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let yr=null;function qh(w){yr&&yr(w)}function ka(){es.stop()}function On(){es.start()}let es=new O0;es.setAnimationLoop(qh),typeof self<"u"&&es.setContext(self),this.setAnimationLoop=function(w){yr=w,lt.setAnimationLoop(w),w===null?es.stop():es.start()},lt.addEventListener("sessionstart",ka),lt.addEventListener("sessionend",On),this.render=function(w,O){if(O!==void 0&&O.isCamera!==!0){jt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;V!==null&&V.renderStart(w,O);let j=lt.enabled===!0&&lt.isPresenting===!0,$=k!==null&&(ct===null||j)&&k.begin(N,ct);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),lt.enabled===!0&&lt.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(lt.cameraAutoUpdate===!0&&lt.updateCamera(O),O=lt.getCamera()),w.isScene===!0&&w.onBeforeRender(N,w,O,ct),A=et.get(w,E.length),A.init(O),A.state.textureUnits=Xt.getTextureUnits(),E.push(A),Ce.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),O.isArrayCamera?We.setFromArrayCamera(O):te.setFromProjectionMatrix(Ce,vn,O.reversedDepth),ri=this.localClippingEnabled,De=nt.init(this.clippingPlanes,ri),R=vt.get(w,_.length),R.init(),_.push(R),this.info.render.frame++,lt.enabled===!0&&lt.isPresenting===!0){let Pt=N.xr.getDepthSensingMesh();Pt!==null&&is(Pt,O,-1/0,N.sortObjects)}is(w,O,0,N.sortObjects),R.finish(),V!==null&&V.updateLights(A.state.lightsArray),N.sortObjects===!0&&R.sort(Gt,ie),Ke=lt.enabled===!1||lt.isPresenting===!1||lt.hasDepthSensing()===!1,Ke&&F.addToRenderList(R,w),this.info.autoReset===!0&&this.info.reset(),De===!0&&nt.beginShadows();let q=A.state.shadowsArray;if(pt.render(q,w,O),De===!0&&nt.endShadows(),($&&k.hasRenderPass())===!1){let Pt=R.opaque,Tt=R.transmissive;if(A.setupLights(),O.isArrayCamera){let It=O.cameras;if(Tt.length>0)for(let Bt=0,Jt=It.length;Bt<Jt;Bt++){let he=It[Bt];Sn(Pt,Tt,w,he)}Ke&&F.render(w);for(let Bt=0,Jt=It.length;Bt<Jt;Bt++){let he=It[Bt];Ao(R,w,he,he.viewport)}}else Tt.length>0&&Sn(Pt,Tt,w,O),Ke&&F.render(w),Ao(R,w,O)}ct!==null&&z===0&&(Xt.updateMultisampleRenderTarget(ct),Xt.updateRenderTargetMipmap(ct)),$&&k.end(N),w.isScene===!0&&w.onAfterRender(N,w,O),Mt.resetDefaultState(),K=-1,Q=null,E.pop(),E.length>0?(A=E[E.length-1],Xt.setTextureUnits(A.state.textureUnits),De===!0&&nt.setGlobalState(N.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?R=_[_.length-1]:R=null,V!==null&&V.renderEnd()};function is(w,O,j,$){if(w.visible===!1)return;if(w.layers.test(O.layers)){if(w.isGroup)j=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(O);else if(w.isLight)A.pushLight(w),w.castShadow&&A.pushShadow(w);else if(w.isSprite){let Pt=O.isArrayCamera?We:te;if(!w.frustumCulled||w.intersectsFrustum(Pt)){$&&ve.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Ce);let Tt=ht.update(w),It=w.material;It.visible&&R.push(w,Tt,It,j,ve.z,null,O)}}else if(w.isMesh||w.isLine||w.isPoints){let Pt=O.isArrayCamera?We:te;if(!w.frustumCulled||w.intersectsFrustum(Pt)){let Tt=ht.update(w),It=w.material;if($&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),ve.copy(w.boundingSphere.center)):(Tt.boundingSphere===null&&Tt.computeBoundingSphere(),ve.copy(Tt.boundingSphere.center)),ve.applyMatrix4(w.matrixWorld).applyMatrix4(Ce)),Array.isArray(It)){let Bt=Tt.groups;for(let Jt=0,he=Bt.length;Jt<he;Jt++){let kt=Bt[Jt],ue=It[kt.materialIndex];ue&&ue.visible&&R.push(w,Tt,ue,j,ve.z,kt,O)}}else It.visible&&R.push(w,Tt,It,j,ve.z,null,O)}}}let Et=w.children;for(let Pt=0,Tt=Et.length;Pt<Tt;Pt++)is(Et[Pt],O,j,$)}function Ao(w,O,j,$){let{opaque:q,transmissive:Et,transparent:Pt}=w;A.setupLightsView(j),De===!0&&nt.setGlobalState(N.clippingPlanes,j),$&&bt.viewport(st.copy($)),q.length>0&&Je(q,O,j),Et.length>0&&Je(Et,O,j),Pt.length>0&&Je(Pt,O,j),bt.buffers.depth.setTest(!0),bt.buffers.depth.setMask(!0),bt.buffers.color.setMask(!0),bt.setPolygonOffset(!1)}function Sn(w,O,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[$.id]===void 0){let kt=$t.has("EXT_color_buffer_half_float")||$t.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[$.id]=new Wi(1,1,{generateMipmaps:!0,type:kt?Fn:dn,minFilter:vs,samples:Math.max(4,ne.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:me.workingColorSpace})}let Et=A.state.transmissionRenderTarget[$.id],Pt=$.viewport||st;Et.setSize(Pt.z*N.transmissionResolutionScale,Pt.w*N.transmissionResolutionScale);let Tt=N.getRenderTarget(),It=N.getActiveCubeFace(),Bt=N.getActiveMipmapLevel();N.setRenderTarget(Et),N.getClearColor(tt),mt=N.getClearAlpha(),mt<1&&N.setClearColor(16777215,.5),N.clear(),Ke&&F.render(j);let Jt=N.toneMapping;N.toneMapping=Jn;let he=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),A.setupLightsView($),De===!0&&nt.setGlobalState(N.clippingPlanes,$),Je(w,j,$),Xt.updateMultisampleRenderTarget(Et),Xt.updateRenderTargetMipmap(Et),$t.has("WEBGL_multisampled_render_to_texture")===!1){let kt=!1;for(let ue=0,qe=O.length;ue<qe;ue++){let Te=O[ue],{object:Ae,geometry:_i,material:Ft,group:ai}=Te;if(Ft.side===Mn&&Ae.layers.test($.layers)){let fe=Ft.side;Ft.side=Xi,Ft.needsUpdate=!0,ii(Ae,j,$,_i,Ft,ai),Ft.side=fe,Ft.needsUpdate=!0,kt=!0}}kt===!0&&(Xt.updateMultisampleRenderTarget(Et),Xt.updateRenderTargetMipmap(Et))}N.setRenderTarget(Tt,It,Bt),N.setClearColor(tt,mt),he!==void 0&&($.viewport=he),N.toneMapping=Jt}function Je(w,O,j){let $=O.isScene===!0?O.overrideMaterial:null;for(let q=0,Et=w.length;q<Et;q++){let Pt=w[q],{object:Tt,geometry:It,group:Bt}=Pt,Jt=Pt.material;Jt.allowOverride===!0&&$!==null&&(Jt=$),Tt.layers.test(j.layers)&&ii(Tt,O,j,It,Jt,Bt)}}function ii(w,O,j,$,q,Et){V!==null&&q.isNodeMaterial&&V.setObject(w,q),w.onBeforeRender(N,O,j,$,q,Et),w.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),q.onBeforeRender(N,O,j,$,w,Et),q.transparent===!0&&q.side===Mn&&q.forceSinglePass===!1?(q.side=Xi,q.needsUpdate=!0,N.renderBufferDirect(j,O,$,q,w,Et),q.side=Gs,q.needsUpdate=!0,N.renderBufferDirect(j,O,$,q,w,Et),q.side=Mn):N.renderBufferDirect(j,O,$,q,w,Et),w.onAfterRender(N,O,j,$,q,Et)}function ni(w){let O=0;for(let j of w)j.texture!==null&&O++;return O}function kn(w,O,j){O.isScene!==!0&&(O=gi);let $=zt.get(w),q=A.state.lights,Et=A.state.shadowsArray,Pt=q.state.version,Tt=ot.getParameters(w,q.state,Et,O,j,A.state.lightProbeGridArray),It=ot.getProgramCacheKey(Tt),Bt=$.programs;$.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?O.environment:null,$.fog=O.fog;let Jt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;$.envMap=C.get(w.envMap||$.environment,Jt),$.envMapRotation=$.environment!==null&&w.envMap===null?O.environmentRotation:w.envMapRotation,Bt===void 0&&(w.addEventListener("dispose",se),Bt=new Map,$.programs=Bt,$.programVariants=new Map);let he=Bt.get(It);if(he!==void 0){if($.currentProgram===he&&$.lightsStateVersion===Pt)return Ro(w,Tt),he}else Tt.uniforms=ot.getUniforms(w),V!==null&&w.isNodeMaterial&&V.build(w,j,Tt),w.onBeforeCompile(Tt,N),he=ot.acquireProgram(Tt,It),Bt.set(It,he),$.uniforms=Tt.uniforms;let kt=$.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(kt.clippingPlanes=nt.uniform),Ro(w,Tt),$.needsLights=bs(w),$.lightsStateVersion=Pt,$.needsLights&&(kt.ambientLightColor.value=q.state.ambient,kt.lightProbe.value=q.state.probe,kt.sunLights.value=q.state.sun,kt.sunLightShadows.value=q.state.sunShadow,kt.directionalLights.value=q.state.directional,kt.directionalLightShadows.value=q.state.directionalShadow,kt.spotLights.value=q.state.spot,kt.spotLightShadows.value=q.state.spotShadow,kt.rectAreaLights.value=q.state.rectArea,kt.ltc_1.value=q.state.rectAreaLTC1,kt.ltc_2.value=q.state.rectAreaLTC2,kt.pointLights.value=q.state.point,kt.pointLightShadows.value=q.state.pointShadow,kt.hemisphereLights.value=q.state.hemi,kt.sunShadowMatrix.value=q.state.sunShadowMatrix,kt.sunShadowCascade.value=q.state.sunShadowCascade,kt.directionalShadowMatrix.value=q.state.directionalShadowMatrix,kt.spotLightMatrix.value=q.state.spotLightMatrix,kt.spotLightMap.value=q.state.spotLightMap,kt.pointShadowMatrix.value=q.state.pointShadowMatrix),$.numLightProbeGrids=ni(A.state.lightProbeGridArray),$.currentProgram=he,$.uniformsList=null,he}function ji(w,O,j,$,q){let Et=zt.get(w),Pt=Et.currentProgram.id+","+$+","+q,Tt=Et.programVariants.get(Pt);return Tt===void 0?(Tt=kn(w,O,j),Et.programVariants.set(Pt,Tt)):(Et.currentProgram=Tt,Et.uniformsList=null,Et.outputColorSpace=$,Et.toneMapping=q),Tt}function Ss(w){if(w.uniformsList===null){let O=w.currentProgram.getUniforms();w.uniformsList=wo.seqWithValue(O.seq,w.uniforms)}return w.uniformsList}function Ro(w,O){let j=zt.get(w);j.outputColorSpace=O.outputColorSpace,j.batching=O.batching,j.batchingColor=O.batchingColor,j.instancing=O.instancing,j.instancingColor=O.instancingColor,j.instancingMorph=O.instancingMorph,j.skinning=O.skinning,j.morphTargets=O.morphTargets,j.morphNormals=O.morphNormals,j.morphColors=O.morphColors,j.morphTargetsCount=O.morphTargetsCount,j.numClippingPlanes=O.numClippingPlanes,j.numIntersection=O.numClipIntersection,j.vertexAlphas=O.vertexAlphas,j.vertexTangents=O.vertexTangents,j.toneMapping=O.toneMapping}function Co(w,O,j,$,q){O.isScene!==!0&&(O=gi),Xt.resetTextureUnits();let Et=O.fog,Pt=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?O.environment:null,Tt=ct===null?N.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:me.workingColorSpace,It=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Bt=C.get($.envMap||Pt,It),Jt=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,he=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),kt=!!j.morphAttributes.position,ue=!!j.morphAttributes.normal,qe=!!j.morphAttributes.color,Te=Jn;$.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(Te=N.toneMapping);let Ae=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,_i=Ae!==void 0?Ae.length:0,Ft=zt.get($),ai=A.state.lights;if(De===!0&&(ri===!0||w!==Q)){let Re=w===Q&&$.id===K;nt.setState($,w,Re)}let fe=!1,ns=!1;$.version===Ft.__version?Ft.needsLights&&Ft.lightsStateVersion!==ai.state.version||q.isBatchedMesh&&Ft.batching===!1||!q.isBatchedMesh&&Ft.batching===!0||q.isBatchedMesh&&Ft.batchingColor===!0&&q._colorsTexture===null||q.isBatchedMesh&&Ft.batchingColor===!1&&q._colorsTexture!==null||q.isInstancedMesh&&Ft.instancing===!1||!q.isInstancedMesh&&Ft.instancing===!0||q.isSkinnedMesh&&Ft.skinning===!1||!q.isSkinnedMesh&&Ft.skinning===!0||q.isInstancedMesh&&Ft.instancingColor===!0&&q.instanceColor===null||q.isInstancedMesh&&Ft.instancingColor===!1&&q.instanceColor!==null||q.isInstancedMesh&&Ft.instancingMorph===!0&&q.morphTexture===null||q.isInstancedMesh&&Ft.instancingMorph===!1&&q.morphTexture!==null||Ft.envMap!==Bt||$.fog===!0&&Ft.fog!==Et||Ft.numClippingPlanes!==void 0&&(Ft.numClippingPlanes!==nt.numPlanes||Ft.numIntersection!==nt.numIntersection)||Ft.vertexAlphas!==Jt||Ft.vertexTangents!==he||Ft.morphTargets!==kt||Ft.morphNormals!==ue||Ft.morphColors!==qe||Ft.morphTargetsCount!==_i||Ft.numLightProbeGrids!==ni(A.state.lightProbeGridArray)?fe=!0:(Ft.outputColorSpace!==Tt||Ft.toneMapping!==Te)&&(ns=!0):(fe=!0,Ft.__version=$.version);let li=Ft.currentProgram;(fe===!0||ns===!0)&&(li=ns===!0?ji($,O,q,Tt,Te):kn($,O,q),V&&$.isNodeMaterial&&V.onUpdateProgram($,li,Ft));let br=!1,Bn=!1,ss=!1,oe=li.getUniforms(),je=Ft.uniforms;if(bt.useProgram(li.program)&&(br=!0,Bn=!0,ss=!0),$.id!==K&&(K=$.id,Bn=!0),br||Q!==w){bt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),oe.setValue(U,"projectionMatrix",w.projectionMatrix),oe.setValue(U,"viewMatrix",w.matrixWorldInverse);let ci=oe.map.cameraPosition;ci!==void 0&&ci.setValue(U,bi.setFromMatrixPosition(w.matrixWorld)),ne.logarithmicDepthBuffer&&oe.setValue(U,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&oe.setValue(U,"isOrthographic",w.isOrthographicCamera===!0),Q!==w&&(Q=w,Bn=!0,ss=!0)}if(Ft.needsLights&&(ai.state.sunShadowMap.length>0&&oe.setValue(U,"sunShadowMap",ai.state.sunShadowMap,Xt),ai.state.directionalShadowMap.length>0&&oe.setValue(U,"directionalShadowMap",ai.state.directionalShadowMap,Xt),ai.state.spotShadowMap.length>0&&oe.setValue(U,"spotShadowMap",ai.state.spotShadowMap,Xt),ai.state.pointShadowMap.length>0&&oe.setValue(U,"pointShadowMap",ai.state.pointShadowMap,Xt)),q.isSkinnedMesh){oe.setOptional(U,q,"bindMatrix"),oe.setOptional(U,q,"bindMatrixInverse");let Re=q.skeleton;Re&&(Re.boneTexture===null&&Re.computeBoneTexture(),oe.setValue(U,"boneTexture",Re.boneTexture,Xt))}q.isBatchedMesh&&(oe.setOptional(U,q,"batchingTexture"),oe.setValue(U,"batchingTexture",q._matricesTexture,Xt),oe.setOptional(U,q,"batchingIdTexture"),oe.setValue(U,"batchingIdTexture",q._indirectTexture,Xt),oe.setOptional(U,q,"batchingColorTexture"),q._colorsTexture!==null&&oe.setValue(U,"batchingColorTexture",q._colorsTexture,Xt));let Bi=j.morphAttributes;if((Bi.position!==void 0||Bi.normal!==void 0||Bi.color!==void 0)&&rt.update(q,j,li),(Bn||Ft.receiveShadow!==q.receiveShadow)&&(Ft.receiveShadow=q.receiveShadow,oe.setValue(U,"receiveShadow",q.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&O.environment!==null&&(je.envMapIntensity.value=O.environmentIntensity),je.dfgLUT!==void 0&&(je.dfgLUT.value=YE()),Bn){if(oe.setValue(U,"toneMappingExposure",N.toneMappingExposure),Ft.needsLights&&Mr(je,ss),Et&&$.fog===!0&&_t.refreshFogUniforms(je,Et),_t.refreshMaterialUniforms(je,$,St,At,A.state.transmissionRenderTarget[w.id]),Ft.needsLights&&Ft.numLightProbeGrids>0){let Re=M,ci=0;for(let Li of A.state.lightProbeGridArray)Li.texture!==null&&(Re.textures[ci]=Li.texture,Re.min[ci]=Li.boundingBox.min,Re.max[ci]=Li.boundingBox.max,Re.resolution[ci]=Li.resolution,ci++);for(let Li in Re)Re[Li].length=ci;je.probesSH.value=Re.textures,je.probesMin.value=Re.min,je.probesMax.value=Re.max,je.probesResolution.value=Re.resolution}wo.upload(U,Ss(Ft),je,Xt)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(wo.upload(U,Ss(Ft),je,Xt),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&oe.setValue(U,"center",q.center),oe.setValue(U,"modelViewMatrix",q.modelViewMatrix),oe.setValue(U,"normalMatrix",q.normalMatrix),oe.setValue(U,"modelMatrix",q.matrixWorld),$.uniformsGroups!==void 0){let Re=$.uniformsGroups;for(let ci=0,Li=Re.length;ci<Li;ci++){let Ba=Re[ci];Ht.update(Ba,li),Ht.bind(Ba,li)}}return li}function Mr(w,O){w.ambientLightColor.needsUpdate=O,w.lightProbe.needsUpdate=O,w.sunLights.needsUpdate=O,w.sunLightShadows.needsUpdate=O,w.directionalLights.needsUpdate=O,w.directionalLightShadows.needsUpdate=O,w.pointLights.needsUpdate=O,w.pointLightShadows.needsUpdate=O,w.spotLights.needsUpdate=O,w.spotLightShadows.needsUpdate=O,w.rectAreaLights.needsUpdate=O,w.hemisphereLights.needsUpdate=O}function bs(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(w,O,j){let $=zt.get(w);$.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),zt.get(w.texture).__webglTexture=O,zt.get(w.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,O){let j=zt.get(w);j.__webglFramebuffer=O,j.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(w,O=0,j=0){ct=w,Z=O,z=j;let $=null,q=!1,Et=!1;if(w){let Tt=zt.get(w);if(Tt.__useDefaultFramebuffer!==void 0){bt.bindFramebuffer(U.FRAMEBUFFER,Tt.__webglFramebuffer),st.copy(w.viewport),dt.copy(w.scissor),ut=w.scissorTest,bt.viewport(st),bt.scissor(dt),bt.setScissorTest(ut),K=-1;return}else if(Tt.__webglFramebuffer===void 0)Xt.setupRenderTarget(w);else if(Tt.__hasExternalTextures)Xt.rebindTextures(w,zt.get(w.texture).__webglTexture,zt.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let Jt=w.depthTexture;if(Tt.__boundDepthTexture!==Jt){if(Jt!==null&&zt.has(Jt)&&(w.width!==Jt.image.width||w.height!==Jt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xt.setupDepthRenderbuffer(w)}}let It=w.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Et=!0);let Bt=zt.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Bt[O])?$=Bt[O][j]:$=Bt[O],q=!0):w.samples>0&&Xt.useMultisampledRTT(w)===!1?$=zt.get(w).__webglMultisampledFramebuffer:Array.isArray(Bt)?$=Bt[j]:$=Bt,st.copy(w.viewport),dt.copy(w.scissor),ut=w.scissorTest}else st.copy(Vt).multiplyScalar(St).floor(),dt.copy(le).multiplyScalar(St).floor(),ut=re;if(j!==0&&($=G),bt.bindFramebuffer(U.FRAMEBUFFER,$)&&bt.drawBuffers(w,$),bt.viewport(st),bt.scissor(dt),bt.setScissorTest(ut),q){let Tt=zt.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+O,Tt.__webglTexture,j)}else if(Et){let Tt=O;for(let It=0;It<w.textures.length;It++){let Bt=zt.get(w.textures[It]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+It,Bt.__webglTexture,j,Tt)}}else if(w!==null&&j!==0){let Tt=zt.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Tt.__webglTexture,j)}K=-1};function Sr(w){let O=zt.get(w);return(O.__readFormat!==w.format||O.__readType!==w.type)&&(O.__readFormat=w.format,O.__readType=w.type,O.__formatReadable=ne.textureFormatReadable(w.format),O.__typeReadable=ne.textureTypeReadable(w.type)),O}this.readRenderTargetPixels=function(w,O,j,$,q,Et,Pt,Tt=0){if(!(w&&w.isWebGLRenderTarget)){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){bt.bindFramebuffer(U.FRAMEBUFFER,It);try{let Bt=w.textures[Tt],Jt=Bt.format,he=Bt.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Tt);let kt=Sr(Bt);if(kt.__formatReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(kt.__typeReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=w.width-$&&j>=0&&j<=w.height-q&&U.readPixels(O,j,$,q,gt.convert(Jt),gt.convert(he),Et)}finally{let Bt=ct!==null?zt.get(ct).__webglFramebuffer:null;bt.bindFramebuffer(U.FRAMEBUFFER,Bt)}}},this.readRenderTargetPixelsAsync=async function(w,O,j,$,q,Et,Pt,Tt=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(O>=0&&O<=w.width-$&&j>=0&&j<=w.height-q){bt.bindFramebuffer(U.FRAMEBUFFER,It);let Bt=w.textures[Tt],Jt=Bt.format,he=Bt.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Tt);let kt=Sr(Bt);if(kt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(kt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ue=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,ue),U.bufferData(U.PIXEL_PACK_BUFFER,Et.byteLength,U.STREAM_READ),U.readPixels(O,j,$,q,gt.convert(Jt),gt.convert(he),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let qe=ct!==null?zt.get(ct).__webglFramebuffer:null;bt.bindFramebuffer(U.FRAMEBUFFER,qe);let Te=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await c0(U,Te,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,ue),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,Et),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(ue),U.deleteSync(Te),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,O=null,j=0){let $=Math.pow(2,-j),q=Math.floor(w.image.width*$),Et=Math.floor(w.image.height*$),Pt=O!==null?O.x:0,Tt=O!==null?O.y:0;Xt.setTexture2D(w,0),U.copyTexSubImage2D(U.TEXTURE_2D,j,0,0,Pt,Tt,q,Et),bt.unbindTexture()},this.copyTextureToTexture=function(w,O,j=null,$=null,q=0,Et=0){let Pt,Tt,It,Bt,Jt,he,kt,ue,qe,Te=w.isCompressedTexture?w.mipmaps[Et]:w.image;if(j!==null)Pt=j.max.x-j.min.x,Tt=j.max.y-j.min.y,It=j.isBox3?j.max.z-j.min.z:1,Bt=j.min.x,Jt=j.min.y,he=j.isBox3?j.min.z:0;else{let oe=Math.pow(2,-q);Pt=Math.floor(Te.width*oe),Tt=Math.floor(Te.height*oe),w.isDataArrayTexture?It=Te.depth:w.isData3DTexture?It=Math.floor(Te.depth*oe):It=1,Bt=0,Jt=0,he=0}$!==null?(kt=$.x,ue=$.y,qe=$.z):(kt=0,ue=0,qe=0);let Ae=gt.convert(O.format),_i=gt.convert(O.type),Ft;O.isData3DTexture?(Xt.setTexture3D(O,0),Ft=U.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(Xt.setTexture2DArray(O,0),Ft=U.TEXTURE_2D_ARRAY):(Xt.setTexture2D(O,0),Ft=U.TEXTURE_2D),bt.activeTexture(U.TEXTURE0),bt.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,O.flipY),bt.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),bt.pixelStorei(U.UNPACK_ALIGNMENT,O.unpackAlignment);let ai=bt.getParameter(U.UNPACK_ROW_LENGTH),fe=bt.getParameter(U.UNPACK_IMAGE_HEIGHT),ns=bt.getParameter(U.UNPACK_SKIP_PIXELS),li=bt.getParameter(U.UNPACK_SKIP_ROWS),br=bt.getParameter(U.UNPACK_SKIP_IMAGES);bt.pixelStorei(U.UNPACK_ROW_LENGTH,Te.width),bt.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Te.height),bt.pixelStorei(U.UNPACK_SKIP_PIXELS,Bt),bt.pixelStorei(U.UNPACK_SKIP_ROWS,Jt),bt.pixelStorei(U.UNPACK_SKIP_IMAGES,he);let Bn=w.isDataArrayTexture||w.isData3DTexture,ss=O.isDataArrayTexture||O.isData3DTexture;if(w.isDepthTexture){let oe=zt.get(w),je=zt.get(O),Bi=zt.get(oe.__renderTarget),Re=zt.get(je.__renderTarget);bt.bindFramebuffer(U.READ_FRAMEBUFFER,Bi.__webglFramebuffer),bt.bindFramebuffer(U.DRAW_FRAMEBUFFER,Re.__webglFramebuffer);for(let ci=0;ci<It;ci++)Bn&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,zt.get(w).__webglTexture,q,he+ci),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,zt.get(O).__webglTexture,Et,qe+ci)),U.blitFramebuffer(Bt,Jt,Bt+Pt,Jt+Tt,kt,ue,kt+Pt,ue+Tt,U.DEPTH_BUFFER_BIT,U.NEAREST);bt.bindFramebuffer(U.READ_FRAMEBUFFER,null),bt.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(q!==0||w.isRenderTargetTexture||zt.has(w)){let oe=zt.get(w),je=zt.get(O);bt.bindFramebuffer(U.READ_FRAMEBUFFER,D),bt.bindFramebuffer(U.DRAW_FRAMEBUFFER,H);for(let Bi=0;Bi<It;Bi++)Bn?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,oe.__webglTexture,q,he+Bi):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,oe.__webglTexture,q),ss?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,je.__webglTexture,Et,qe+Bi):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,je.__webglTexture,Et),q!==0?U.blitFramebuffer(Bt,Jt,Bt+Pt,Jt+Tt,kt,ue,kt+Pt,ue+Tt,U.COLOR_BUFFER_BIT,U.NEAREST):ss?U.copyTexSubImage3D(Ft,Et,kt,ue,qe+Bi,Bt,Jt,Pt,Tt):U.copyTexSubImage2D(Ft,Et,kt,ue,Bt,Jt,Pt,Tt);bt.bindFramebuffer(U.READ_FRAMEBUFFER,null),bt.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else ss?w.isDataTexture||w.isData3DTexture?U.texSubImage3D(Ft,Et,kt,ue,qe,Pt,Tt,It,Ae,_i,Te.data):O.isCompressedArrayTexture?U.compressedTexSubImage3D(Ft,Et,kt,ue,qe,Pt,Tt,It,Ae,Te.data):U.texSubImage3D(Ft,Et,kt,ue,qe,Pt,Tt,It,Ae,_i,Te):w.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,Et,kt,ue,Pt,Tt,Ae,_i,Te.data):w.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,Et,kt,ue,Te.width,Te.height,Ae,Te.data):U.texSubImage2D(U.TEXTURE_2D,Et,kt,ue,Pt,Tt,Ae,_i,Te);bt.pixelStorei(U.UNPACK_ROW_LENGTH,ai),bt.pixelStorei(U.UNPACK_IMAGE_HEIGHT,fe),bt.pixelStorei(U.UNPACK_SKIP_PIXELS,ns),bt.pixelStorei(U.UNPACK_SKIP_ROWS,li),bt.pixelStorei(U.UNPACK_SKIP_IMAGES,br),Et===0&&O.generateMipmaps===!0&&O.mipmapsAutoUpdate===!0&&U.generateMipmap(Ft),bt.unbindTexture()},this.initRenderTarget=function(w){zt.get(w).__webglFramebuffer===void 0&&Xt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Xt.setTextureCube(w,0):w.isData3DTexture?Xt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Xt.setTexture2DArray(w,0):Xt.setTexture2D(w,0),bt.unbindTexture()},this.resetState=function(){Z=0,z=0,ct=null,bt.reset(),Mt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return vn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=me._getDrawingBufferColorSpace(t),e.unpackColorSpace=me._getUnpackColorSpace()}};function ts(n,t,e,i){return new xo({glslVersion:Pa,vertexShader:n,fragmentShader:t,uniforms:e,transparent:!0,depthTest:i,depthWrite:i,side:Mn})}function Ua(n,t,e,i=!1){let s=ts(n,t,e,!1);return s.blending=i?Xc:xs,i&&(s.blendEquation=$c,s.blendSrc=Ma,s.blendDst=Ma),s}var Un=`
precision highp float;
precision highp int;
uniform mat4 view;
uniform mat4 projection;
uniform vec3 eye;
uniform vec3 up;
uniform vec3 right;
uniform float pixel;   // metres per CSS pixel at a depth of one metre
uniform float ratio;   // device pixels per CSS pixel
uniform vec3 key;      // direction to the light
`,kh=`
// The direction to the side of a line through a node, at a right angle to "sight" (length 1),
// drawn out at a bend so that the ribbon keeps its width; sharp folds are cut off.
vec3 sideways(vec3 before, vec3 here, vec3 after, vec3 sight) {
  vec3 a = cross(here - before, sight);
  vec3 b = cross(after - here, sight);
  float la = length(a), lb = length(b);
  a = la > 0.0 ? a / la : vec3(0.0);
  b = lb > 0.0 ? b / lb : a;
  if (la == 0.0) a = b;
  vec3 sum = a + b;
  float size = length(sum);
  if (size < 0.7) return b;
  sum /= size;
  return sum / max(0.6, dot(sum, b));
}
`,Y0=`${Un}${kh}
uniform highp sampler2D points;
uniform int columns;
uniform int head;
in vec3 tint;
out float across;
out float age;
out vec3 colourOf;
vec3 point(int row, int step) {
  return texelFetch(points, ivec2((head + clamp(step, 0, columns - 1)) % columns, row), 0).xyz;
}
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  int row = i / columns, step = i % columns;
  vec3 here = point(row, step);
  vec3 side = sideways(point(row, step - 1), here, point(row, step + 1), normalize(eye - here));
  float perPixel = pixel * -(view * vec4(here, 1.0)).z;
  age = 1.0 - float(step) / float(columns - 1);
  colourOf = tint;
  gl_Position = projection * view * vec4(here + side * across * 2.0 * perPixel, 1.0);
}
`,Z0=`
precision highp float;
in float across;
in float age;
in vec3 colourOf;
out vec4 colour;
void main() {
  float cover = clamp(1.8 - 2.0 * abs(across), 0.0, 1.0);
  colour = vec4(colourOf, 0.75 * cover * (1.0 - age) * (1.0 - age));
}
`,K0=`${Un}
in vec3 position;
in vec4 ink;           // colour, kind: 0 ball, 1 eye bolt, 2 ring
in vec2 sizes;         // diameter [m], least diameter in CSS pixels
out vec4 colourOf;
out float diameter;    // CSS pixels
void main() {
  vec4 seen = view * vec4(position, 1.0);
  diameter = max(sizes.x / (pixel * -seen.z), sizes.y);
  colourOf = ink;
  gl_Position = projection * seen;
  seen.z *= 1.0 - min(0.5, pixel * diameter);  // before the rope that ends in it
  vec4 nearer = projection * seen;
  gl_Position.z = nearer.z / nearer.w * gl_Position.w;
  gl_PointSize = (diameter + 2.0) * ratio;
}
`,J0=`${Un}
in vec4 colourOf;
in float diameter;
out vec4 colour;
void main() {
  float radius = 0.5 * diameter;
  vec2 at = (gl_PointCoord * 2.0 - 1.0) * vec2(1.0, -1.0) * (radius + 1.0);
  int kind = int(colourOf.w + 0.5);
  if (kind == 2) {
    float band = abs(length(at) - radius + 1.2) - 1.2;
    colour = vec4(colourOf.rgb, clamp(0.5 - band, 0.0, 1.0));
  } else if (kind == 1) {
    float tube = 0.3 * radius;
    float x = (length(at) - 0.7 * radius) / tube;
    float z = sqrt(max(0.0, 1.0 - x * x));
    vec3 n = vec3(at / max(length(at), 1e-3) * clamp(x, -1.0, 1.0), z);
    float light = 0.42 + 0.62 * max(dot(n, normalize(vec3(-0.35, 0.8, 0.6))), 0.0);
    float glint = pow(max(dot(n, normalize(vec3(-0.2, 0.6, 0.9))), 0.0), 24.0);
    colour = vec4(colourOf.rgb * light + 0.25 * glint, clamp(tube * (1.0 - abs(x)) + 0.5, 0.0, 1.0));
  } else {
    float cover = clamp(radius + 0.5 - length(at), 0.0, 1.0);
    vec2 n = at / radius;
    float z = sqrt(max(0.0, 1.0 - dot(n, n)));
    float light = 0.62 + 0.42 * max(dot(vec3(n, z), normalize(vec3(0.35, 0.8, 0.7))), 0.0);
    float glint = pow(max(dot(vec3(n, z), normalize(vec3(0.2, 0.5, 0.9))), 0.0), 30.0);
    colour = vec4(colourOf.rgb * light + 0.18 * glint, cover);
  }
  if (colour.a <= 0.0) discard;
}
`,j0=`${Un}
uniform highp sampler2D points;
uniform int columns;
uniform float dot_;    // CSS pixels
void main() {
  vec4 here = texelFetch(points, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0);
  vec4 seen = view * vec4(here.xyz, 1.0);
  seen.z += 0.02 * -seen.z;
  gl_Position = projection * seen;
  gl_PointSize = here.w > 1e30 ? 0.0 : dot_ * ratio;
}
`,Q0=`
precision highp float;
uniform vec3 ink;
out vec4 colour;
void main() {
  float away = length(gl_PointCoord * 2.0 - 1.0);
  float cover = 1.0 - smoothstep(0.7, 1.0, away);
  if (cover <= 0.0) discard;
  colour = vec4(ink, cover);
}
`,t_=`${Un}
in vec3 position;      // a place on the arrow's line
in vec3 line;          // the arrow's direction
in vec4 ink;           // colour, CSS pixels to the side
in float edge;         // half the arrow's width there [CSS pixels]
out vec3 colourOf;
out float away;
out float halfWidth;
void main() {
  vec3 side = cross(line, eye - position);
  float size = length(side);
  side = size > 0.0 ? side / size : right;
  float perPixel = pixel * -(view * vec4(position, 1.0)).z;
  colourOf = ink.rgb;
  away = ink.w;
  halfWidth = edge;
  gl_Position = projection * view * vec4(position + side * ink.w * perPixel, 1.0);
}
`,e_=`
precision highp float;
in vec3 colourOf;
in float away;
in float halfWidth;
uniform float round_;  // 1: shaded as a round bar
out vec4 colour;
void main() {
  float u = clamp(away / max(halfWidth, 1.0), -1.0, 1.0);
  float light = mix(1.0, 0.55 + 0.5 * sqrt(max(0.0, 1.0 - (u + 0.35) * (u + 0.35) / 1.9)), round_);
  colour = vec4(colourOf * light, clamp(halfWidth + 0.5 - abs(away), 0.0, 1.0));
}
`;var _f=256,xf=7,i_=[0,1,2,1,3,2,4,5,6],Oa=class{constructor(t,e=!1){let i=new mi;for(let[r,o]of[["position",3],["line",3],["ink",4],["edge",1]]){let a=new si(new Float32Array(o*xf*_f),o);a.setUsage(Ca),i.setAttribute(r,a)}let s=[];for(let r=0;r<_f;r++)s.push(...i_.map(o=>o+xf*r));i.setIndex(s),this.mesh=new yi(i,ts(t_,e_,{...t,round_:{value:Number(e)}},e)),this.mesh.frustumCulled=!1,this.mesh.renderOrder=e?.5:2.5}update(t,e){let i=Math.min(_f,t.length);if(this.mesh.visible=i>0,!i)return;let s=this.mesh.geometry,[r,o,a,l]=["position","line","ink","edge"].map(c=>s.getAttribute(c));for(let c=0;c<i;c++){let{from:h,to:d,colour:u,pixels:f,head:m}=t[c],v=[d[0]-h[0],d[1]-h[1],d[2]-h[2]],g=Math.hypot(v[0],v[1],v[2]),p=m&&g>0?Math.min(.5,5.5*f*e/g):0,y=f/2,T=m?2.2*f:0;[[0,y,-1],[0,y,1],[1-p,y,-1],[1-p,y,1],[1-p,T,-1],[1-p,T,1],[1,0,0]].forEach(([R,A,_],E)=>{let k=xf*c+E;r.setXYZ(k,h[0]+R*v[0],h[1]+R*v[1],h[2]+R*v[2]),o.setXYZ(k,v[0],v[1],v[2]),a.setXYZW(k,u[0],u[1],u[2],_*(A&&A+1)),l.setX(k,A)})}r.needsUpdate=o.needsUpdate=a.needsUpdate=l.needsUpdate=!0,s.setDrawRange(0,i_.length*i)}};var n_=`
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.5, 1.0);
}
`,ZE=`${Un}
uniform vec2 size;     // of the picture [CSS pixels]
uniform vec3 top;
uniform vec3 ahead;
uniform vec3 first;
uniform vec3 second;
uniform vec3 center;   // on the ground, on a crossing of lines
uniform float spacing; // of the lines [m]
uniform float reach;   // how far the floor is seen [m]
uniform float solid;   // 1: there is a ground to land on
uniform vec3 sky;
uniform vec3 horizon;
uniform vec3 ground;
uniform vec3 grid;
uniform float pool;    // how much lighter the middle is
out vec4 colour;
// How much of a pixel a line covers: "at" in lines, "wide" pixels; "step_" lines per pixel.
float line(float at, float step_, float wide) {
  float away = abs(fract(at - 0.5) - 0.5) / max(step_, 1e-6);
  float part = clamp(0.5 * wide + 0.5 - away, 0.0, 1.0);
  return mix(part, min(1.0, wide * step_), smoothstep(0.15, 0.5, step_));
}
void main() {
  vec2 at = gl_FragCoord.xy / ratio - 0.5 * size;
  vec3 ray = ahead + (right * at.x + top * at.y) * pixel;
  float rise = dot(normalize(ray), up);
  vec3 highest = ahead + top * (0.5 * size.y * pixel);
  float most = max(dot(normalize(highest), up), 0.12);
  vec3 shown = mix(horizon, sky, smoothstep(0.0, 1.0, clamp(rise / most, 0.0, 1.0)));
  float above = dot(eye - center, up);
  float away = above / max(abs(dot(ray, up)), 1e-5) * (rise < 0.0 ? 1.0 : -1.0);
  if (away > 0.0) {
    vec3 place = eye + ray * away - center;
    vec2 q = vec2(dot(place, first), dot(place, second)) / spacing;
    float far = length(q) * spacing / reach;
    float fade = exp(-2.4 * far * far);
    // The size of a pixel on the floor: along the ray it is drawn out.
    float perPixel = pixel * away * length(ray);
    float drawn = perPixel / max(abs(rise), 1e-3);
    vec3 level = ray - up * dot(ray, up);
    vec2 flow = abs(vec2(dot(level, first), dot(level, second))) / max(length(level), 1e-6);
    vec2 step_ = (perPixel + (drawn - perPixel) * flow) / spacing;
    float fine = max(line(q.x, step_.x, 1.0), line(q.y, step_.y, 1.0));
    float coarse = max(line(q.x / 5.0, step_.x / 5.0, 1.5), line(q.y / 5.0, step_.y / 5.0, 1.5));
    float ink = max(0.5 * fine * exp(-5.0 * far * far), coarse) * fade;
    if (above > 0.0) {
      vec3 floor_ = ground + pool * exp(-9.0 * far * far);
      shown = mix(horizon, floor_, clamp(1.25 * fade, 0.0, 1.0));
      shown = mix(shown, grid, 0.9 * ink);
    } else shown = mix(shown, grid, 0.5 * ink);
  }
  // A little noise, so that no bands are seen.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  colour = vec4(shown + (noise - 0.5) / 255.0, 1.0);
}
`,KE=`
precision highp float;
uniform highp sampler2D backdrop;
out vec4 colour;
void main() { colour = texelFetch(backdrop, ivec2(gl_FragCoord.xy), 0); }
`,Bh=class{constructor(t){this.shared=t;let e=()=>({value:new J});this.uniforms={size:{value:new ge(1,1)},top:e(),ahead:e(),first:e(),second:e(),center:e(),spacing:{value:1},reach:{value:1},solid:{value:0},sky:e(),horizon:e(),ground:e(),grid:e(),pool:{value:0}},this.target=new Wi(1,1,{depthBuffer:!1}),this.target.texture.minFilter=this.target.texture.magFilter=pi,this.texture={value:this.target.texture},this.scene=new cr,this.scene.add(s_(Ua(n_,ZE,{...t,...this.uniforms}))),this.mesh=s_(Ua(n_,KE,{backdrop:this.texture})),this.mesh.renderOrder=-5,this.key=""}setTheme(t){let{sky:e,horizon:i,ground:s,grid:r,pool:o}=this.uniforms;e.value.set(...t.background),i.value.set(...t.horizon),s.value.set(...t.ground),r.value.set(...t.grid),o.value=Yf(t.dark),this.key=""}resize(t,e){this.target.setSize(t,e),this.key=""}update(t,e,i,s){let r=[s.version,i.height,i.spacing,i.solid,...i.center].join();if(r===this.key)return;this.key=r;let{uniforms:o}=this;o.size.value.set(s.width,s.height),o.top.value.set(...s.top),o.ahead.value.set(-s.toward[0],-s.toward[1],-s.toward[2]),o.first.value.set(...s.first),o.second.value.set(...s.second),o.center.value.set(...i.center),o.spacing.value=i.spacing,o.reach.value=i.radius,o.solid.value=i.solid?1:0,t.setRenderTarget(this.target),t.render(this.scene,e),t.setRenderTarget(null)}dispose(){this.target.dispose()}};function s_(n){let t=new mi;t.setIndex([0,1,2]);let e=new yi(t,n);return e.frustumCulled=!1,e}var JE={round:0,eye:1,ring:2},zh=class{constructor(t){this.room=0,this.points=new dr(void 0,ts(K0,J0,t,!0)),this.points.frustumCulled=!1,this.points.renderOrder=3,this.grow(32)}grow(t){this.room=t,this.points.geometry.dispose();let e=new mi;for(let[i,s]of[["position",3],["ink",4],["sizes",2]]){let r=new si(new Float32Array(s*t),s);r.setUsage(Ca),e.setAttribute(i,r)}this.points.geometry=e}update(t){t.length>this.room&&this.grow(2*t.length);let e=this.points.geometry,[i,s,r]=["position","ink","sizes"].map(o=>e.getAttribute(o));t.forEach((o,a)=>{i.setXYZ(a,o.x,o.y,o.z);let[l,c,h]=o.colour;s.setXYZW(a,l,c,h,JE[o.kind]),r.setXY(a,o.size,o.pixels)}),i.needsUpdate=s.needsUpdate=r.needsUpdate=!0,e.setDrawRange(0,t.length),this.points.visible=t.length>0}};var r_=`
uniform highp sampler2D points;
uniform int columns;
uniform float least;   // least width in CSS pixels
in vec4 look;          // radius [m], has a point before, after, length of rope to a free end [m]
vec4 point(int i) { return texelFetch(points, ivec2(i % columns, i / columns), 0); }
`,o_=`${Un}${kh}${r_}
uniform highp sampler2D normals; // of the rope, and the length of rope up to here [m]
uniform float laid;    // 1: there are strands
uniform float thick;   // the least radius as drawn in the scene's middle [m]
in vec3 tint;
out float across;
out float halfWidth;   // CSS pixels
out float value;
out float phase;       // turns of the strands
out vec2 turn;         // the rope's normal, as seen: to the side and towards the eye
out float slope;       // of the rope towards the eye
out float toEnd;       // radii to a free end
out vec3 side;
out vec3 toward;
out vec3 ropeTint;
out float behind;
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec4 here = point(i);
  vec3 before = look.y > 0.5 ? point(i - 1).xyz : here.xyz;
  vec3 after = look.z > 0.5 ? point(i + 1).xyz : here.xyz;
  vec3 sight = normalize(eye - here.xyz);
  vec3 out_ = sideways(before, here.xyz, after, sight);
  float depth = -(view * vec4(here.xyz, 1.0)).z;
  behind = depth > 0.0 ? 0.0 : 1.0;
  float perPixel = pixel * max(depth, 1e-3);
  halfWidth = max(look.x / perPixel, 0.5 * least);
  value = here.w;
  ropeTint = tint;
  vec3 along = after - before;
  along = length(along) > 0.0 ? normalize(along) : right;
  float size = length(out_);
  side = size > 0.0 ? out_ / size : right;
  toward = normalize(cross(side, along));
  vec4 material = laid < 0.5 ? vec4(up, 0.0) : texelFetch(normals, ivec2(i % columns, i / columns), 0);
  turn = vec2(dot(material.xyz, side), dot(material.xyz, toward));
  float radius = max(look.x, 1e-9); // where ropes are drawn thicker than they are, their lay is longer
  float lay = 7.0 * radius * exp2(floor(log2(max(thick / radius, 1.0)) + 0.5));
  phase = material.w / lay;
  float cot = dot(along, sight) / max(length(cross(along, sight)), 1e-3);
  slope = cot / sqrt(1.0 + 0.6 * cot * cot);
  toEnd = look.w / (halfWidth * perPixel);
  vec3 place = here.xyz + out_ * across * (halfWidth + 1.0) * perPixel;
  gl_Position = projection * view * vec4(place, 1.0);
}
`,a_=`${Un}
uniform sampler2D map;
uniform vec2 range;    // values of the map's two ends
uniform bool plain;
uniform float rim;     // what is left of the light at the rope's edge: 1 where the floor is dark
uniform float laid;    // 1: draw strands
in float across;
in float halfWidth;
in float value;
in float phase;
in vec2 turn;
in float slope;
in float toEnd;
in vec3 side;
in vec3 toward;
in vec3 ropeTint;
in float behind;       // > 0: a part of a segment that ends behind the eye
out vec4 colour;
const float CENTRE = 0.5359, STRAND = 0.4641; // of three strands in a rope of radius 1
void main() {
  if (behind > 0.0 || value > 1e30) discard;
  float w = across * (halfWidth + 1.0);
  float u = clamp(w / halfWidth, -1.0, 1.0);
  vec3 n = vec3(u, sqrt(1.0 - u * u), 0.0); // to the side, towards the eye, along
  float edge = 1.0, shade = 1.0;
  float strands = laid * smoothstep(1.6, 3.2, halfWidth);
  bool whipped = toEnd < 4.2;
  if (strands > 0.0 && !whipped) {
    float angle = 6.2831853 * (phase + slope * n.y * 0.1214);
    float c = cos(angle), s = sin(angle);
    vec2 t = normalize(turn + 1e-6);
    vec2 centre = CENTRE * vec2(t.x * c + t.y * s, t.y * c - t.x * s);
    float best = -2.0, outer = -1.0;
    vec2 hit = centre;
    for (int k = 0; k < 3; k++) {
      float off = u - centre.x;
      float q = STRAND * STRAND - off * off;
      float z = centre.y + sqrt(max(q, 0.0));
      if (q > 0.0 && z > best) { best = z; hit = centre; }
      outer = max(outer, sign(u) * centre.x + STRAND);
      centre = vec2(-0.5 * centre.x - 0.8660254 * centre.y, 0.8660254 * centre.x - 0.5 * centre.y);
    }
    vec2 o = vec2(u - hit.x, max(best, hit.y) - hit.y) / STRAND;
    vec3 lie = vec3(0.8976 * hit.y, -0.8976 * hit.x, 1.0); // the direction of the strand
    vec3 m = vec3(o, 0.0);
    m = normalize(m - lie * (dot(m, lie) / dot(lie, lie)));
    float groove = smoothstep(0.46, 0.93, length(vec2(u, best)));
    n = normalize(mix(n, m, strands));
    edge = mix(1.0, outer, strands);
    shade = mix(1.0, 0.42 + 0.58 * groove, strands * mix(0.7, 1.0, smoothstep(4.0, 10.0, halfWidth)));
  }
  float cover = clamp(edge * halfWidth + 0.5 - abs(w), 0.0, 1.0);
  if (cover <= 0.0) discard;
  float part = (value - range.x) / max(range.y - range.x, 1e-30);
  vec3 base = plain ? ropeTint : texture(map, vec2(clamp(part, 0.002, 0.998), 0.5)).rgb;
  if (whipped) {
    base = vec3(0.86, 0.82, 0.74); // whipped with twine
    shade = 0.8 + 0.2 * cos(toEnd * 9.0);
  }
  vec3 normal = normalize(side) * n.x + normalize(toward) * n.y + cross(toward, side) * n.z;
  float wrapped = max(dot(normal, key) + 0.25, 0.0) / 1.25;
  float front = max(n.y, 0.0);
  float light = (0.36 + 0.2 * dot(normal, up) + 0.62 * wrapped * wrapped + 0.3 * front) * shade;
  vec3 half_ = normalize(key + normalize(toward));
  float sheen = 0.1 * pow(max(dot(normal, half_), 0.0), 22.0);
  float band = 1.0 - smoothstep(0.7, 2.0, edge * halfWidth - abs(w));
  vec3 lit = base * base * light * mix(1.0, rim, band) + sheen * shade;
  colour = vec4(sqrt(lit), cover);
}
`,l_=`${Un}${kh}${r_}
uniform float height;  // of the ground along up [m]
out float across;
out float strength;
out float sharp;
vec3 fallen(int i) {
  vec3 p = point(i).xyz;
  float above = dot(p, up) - height;
  vec3 level = key - up * dot(key, up);
  return p - above * (up + 0.75 * level / dot(key, up));
}
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec3 here = fallen(i);
  vec3 before = look.y > 0.5 ? fallen(i - 1) : here;
  vec3 after = look.z > 0.5 ? fallen(i + 1) : here;
  vec3 side = sideways(before, here, after, up);
  float above = dot(point(i).xyz, up) - height;
  float perPixel = pixel * max(-(view * vec4(here, 1.0)).z, 1e-3);
  float radius = max(look.x, 0.5 * least * perPixel);
  float blur = 0.11 * max(above, 0.0);
  float wide = sqrt(radius * radius + blur * blur);
  strength = above < -radius ? 0.0 : radius / (radius + 0.38 * blur);
  if (point(i).w > 1e30) strength = 0.0;
  strength *= min(look.y, look.z); // it fades out at the ends
  sharp = radius / wide;
  gl_Position = projection * view * vec4(here + side * across * 1.7 * wide, 1.0);
}
`,c_=`
precision highp float;
uniform highp sampler2D backdrop;
uniform float ink;
in float across;
in float strength;
in float sharp;
out vec4 colour;
void main() {
  float soft = exp(-3.0 * across * across) - 0.05;
  float hard = 1.0 - smoothstep(0.45, 0.8, abs(across));
  float dark = ink * strength * max(mix(soft, hard, sharp * sharp), 0.0);
  colour = vec4(texelFetch(backdrop, ivec2(gl_FragCoord.xy), 0).rgb * (1.0 - dark), 1.0);
}
`;var u_=1e6,Vh=class{constructor(t,e){this.uniforms={points:{value:null},normals:{value:null},columns:{value:1},least:{value:4},thick:{value:1},laid:{value:1},map:{value:null},range:{value:new ge(0,1)},plain:{value:!1},rim:{value:1},height:{value:0}},this.shadowInk={value:.3},this.dotInk={value:new J(0,0,0)};let i={...t,...this.uniforms};this.ropes=new yi(void 0,ts(o_,a_,i,!0)),this.shadow=new yi(void 0,Ua(l_,c_,{...i,backdrop:e,ink:this.shadowInk},!0)),this.dots=new dr(void 0,ts(j0,Q0,{...i,ink:this.dotInk,dot_:{value:5}},!0)),this.shadow.renderOrder=-2,this.ropes.renderOrder=1,this.dots.renderOrder=2;for(let s of[this.ropes,this.shadow,this.dots])s.frustumCulled=!1}setTheme(t){this.uniforms.map.value?.dispose(),this.uniforms.map.value=tT(t.dark),this.uniforms.rim.value=t.rim,this.shadowInk.value=t.dark?.75:.42,this.dotInk.value.set(...t.node)}setLine(t){let e=QE(t.shape);this.ropes.geometry.dispose(),this.ropes.geometry=e,this.shadow.geometry=e;let i=new mi,s=t.shape.ropes.flatMap(({first:r,count:o})=>Array.from({length:Math.ceil(o/t.steps)},(a,l)=>r+l*t.steps));i.setIndex(new si(new Uint32Array(s),1)),this.dots.geometry.dispose(),this.dots.geometry=i;for(let r of["points","normals"])this.uniforms[r].value?.dispose(),this.uniforms[r].value=jE(t[r]);this.uniforms.columns.value=nr(t.points.length/4)[0],this.uniforms.laid.value=t.framed?1:0}moved(){let{points:t,normals:e,laid:i}=this.uniforms;t.value&&(t.value.needsUpdate=!0),e.value&&i.value&&(e.value.needsUpdate=!0)}dispose(){this.uniforms.points.value?.dispose(),this.uniforms.normals.value?.dispose(),this.uniforms.map.value?.dispose(),this.ropes.geometry.dispose(),this.dots.geometry.dispose()}};function jE(n){let[t,e]=nr(n.length/4),i=new gs(n,t,e,qi,$i);return i.internalFormat="RGBA32F",i.needsUpdate=!0,i}function QE(n){let t=new Float32Array(8*n.nodes),e=new Float32Array(6*n.nodes),i=[];for(let r of n.ropes)for(let o=0;o<r.count;o++){let a=r.first+o,l=o>0,c=o<r.count-1,h=Math.min(r.loose[0]?o*r.spacing:u_,r.loose[1]?(r.count-1-o)*r.spacing:u_);for(let d of[2*a,2*a+1])t.set([r.radius,Number(l),Number(c),h],4*d),e.set(r.colour,3*d);if(c){let d=2*a;i.push(d,d+1,d+2,d+1,d+3,d+2)}}let s=new mi;return s.setAttribute("look",new si(t,4)),s.setAttribute("tint",new si(e,3)),s.setIndex(new si(new Uint32Array(i),1)),s}function tT(n){let t=new Uint8Array(4*256);Dr(n).forEach((i,s)=>t.set([...i.map(r=>Math.round(255*r)),255],4*s));let e=new gs(t,256,1);return e.minFilter=Ci,e.magFilter=Ci,e.needsUpdate=!0,e}var Hh=class{constructor(t){this.uniforms={points:{value:null},columns:{value:360},head:{value:0}},this.mesh=new yi(void 0,ts(Y0,Z0,{...t,...this.uniforms},!1)),this.mesh.frustumCulled=!1,this.trails=null,this.version=-1}update(t){if(this.mesh.visible=t!==null&&!t.empty,!t||(t!==this.trails&&this.rebuild(t),t.version===this.version))return;this.version=t.version,this.uniforms.head.value=t.head;let e=this.uniforms.points.value;e&&(e.needsUpdate=!0)}rebuild(t){this.trails=t,this.version=-1;let e=t.nodes.length;this.uniforms.points.value?.dispose();let i=new gs(t.points,360,e,qi,$i);i.internalFormat="RGBA32F",this.uniforms.points.value=i;let s=new Float32Array(6*360*e),r=[];for(let a=0;a<e;a++)for(let l=0;l<360;l++){let c=2*(a*360+l);s.set([...t.colours[a],...t.colours[a]],3*c),l<359&&r.push(c,c+1,c+2,c+1,c+3,c+2)}let o=new mi;o.setAttribute("tint",new si(s,3)),o.setIndex(r),this.mesh.geometry.dispose(),this.mesh.geometry=o}};var eT=[24e3,4e4],iT=[2400,2600],nT=.65,Gh=class{constructor(t){let e=t.getContext("webgl2",{antialias:!1,alpha:!1,powerPreference:"high-performance"});if(!e)throw new Error("no WebGL2");this.name="webgl",this.canvas=t,this.three=new Fh({canvas:t,context:e,antialias:!1}),this.three.outputColorSpace=Us,this.shared={view:{value:new Ue},projection:{value:new Ue},eye:{value:new J},up:{value:new J},right:{value:new J},key:{value:new J(0,0,1)},pixel:{value:.001},ratio:{value:1}},this.scene=new cr,this.scene.matrixWorldAutoUpdate=!1,this.camera=new fr,this.soft=sT(e),this.line=new Jr(...this.soft?iT:eT),this.backdrop=new Bh(this.shared),this.ribbons=new Vh(this.shared,this.backdrop.texture),this.markers=new zh(this.shared),this.arrows=new Oa(this.shared),this.posts=new Oa(this.shared,!0),this.trails=new Hh(this.shared),this.scene.add(this.backdrop.mesh,this.ribbons.shadow,this.trails.mesh,this.ribbons.ropes,this.ribbons.dots,this.markers.points,this.arrows.mesh,this.posts.mesh)}setShape(t){this.line.setShape(t)}setTheme(t){let e=new _e().setRGB(...t.background,Us);this.three.setClearColor(e,1),this.backdrop.setTheme(t),this.ribbons.setTheme(t)}resize(t,e,i){this.three.setPixelRatio(i),this.three.setSize(t,e,!1),this.shared.ratio.value=i,this.backdrop.resize(this.canvas.width,this.canvas.height)}draw(t){let{camera:e}=t;this.shared.view.value.fromArray(e.view),this.shared.projection.value.fromArray(e.projection),this.shared.eye.value.set(...e.eye),this.shared.up.value.set(...e.up),this.shared.right.value.set(...e.right),this.shared.pixel.value=1/e.focal,this.shared.key.value.set(...e.light),this.line.update(t)?this.ribbons.setLine(this.line):t.moved&&this.ribbons.moved();let i=this.ribbons.uniforms,s=.5*t.pixels*e.pose.distance/e.focal;Math.abs(Math.log2(s/i.thick.value))>nT&&(i.thick.value=s),i.range.value.set(t.range.low,t.range.high),i.plain.value=t.plain,i.least.value=t.pixels,i.height.value=t.ground.height,this.ribbons.shadow.visible=e.eyeHeight(t.ground.height)>0,this.ribbons.dots.visible=t.dots,this.backdrop.update(this.three,this.camera,t.ground,e),this.markers.update(t.markers),this.arrows.update(t.arrows,e.pose.distance/e.focal),this.posts.update(t.posts,e.pose.distance/e.focal),this.trails.update(t.trails),this.three.render(this.scene,this.camera)}clear(){this.three.clear()}dispose(){this.ribbons.dispose(),this.backdrop.dispose(),this.three.dispose()}};function sT(n){let t=n.getExtension("WEBGL_debug_renderer_info"),e=t?String(n.getParameter(t.UNMASKED_RENDERER_WEBGL)):"";return/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)}function d_(n){if(new URLSearchParams(location.search).get("renderer")!=="canvas")try{return new Gh(n)}catch(e){console.info("Canvas 2D is used:",e);let i=n.cloneNode();return n.replaceWith(i),new ta(i)}return new ta(n)}var Wh=class{constructor(){this.listeners=new Map}on(t,e){let i=this.listeners.get(t)??[];i.push(e),this.listeners.set(t,i)}emit(t,e){for(let i of this.listeners.get(t)??[])i(e)}};var Xh=class extends Wh{constructor(t){super(),this.source=t,this.hello=null,this.layout=null,this.parameters=[],this.presets=[],this.status=null,this.stability=[],this.broken=null,this.frame=null,this.frames=0,this.connection="connecting",this.lastId=0,this.pendingFrame=-1,this.resting=!1,this.waiting=new Map}open(){this.source.open({message:t=>this.take(t),frame:t=>this.takeFrame(t),state:(t,e)=>{if(this.connection=t,t!=="open"){let i={type:"error",text:"The server is not there."};for(let{reject:s}of this.waiting.values())s(i);this.waiting.clear()}this.emit("connection",{state:t,text:e})}})}can(t){return this.hello?.can.includes(t)??!1}send(t){this.can(t.type)&&this.source.send(t)}ask(t){let e=++this.lastId;return new Promise((i,s)=>{if(!this.can(t.type)){s({type:"error",text:`${t.type}: cannot be done here`});return}this.waiting.set(e,{resolve:i,reject:s}),this.source.send({...t,id:e})})}async tell(t){try{return await this.ask(t),!0}catch(e){return this.emit("error",e),!1}}take(t){switch(t.type){case"hello":this.hello=t;break;case"layout":t.layout!==this.layout?.layout&&(this.frame=null),this.layout=t;break;case"parameters":this.parameters=t.parameters,this.emit("parameters",this.parameters);return;case"presets":this.presets=t.presets,this.emit("presets",this.presets);return;case"status":this.status=t,!t.broken&&this.broken&&(this.broken=null,this.emit("broken",null));break;case"stability":this.stability=t.variants,this.emit("stability",this.stability);return;case"broken":this.broken=t;break;case"done":case"error":this.answer(t);return}this.emit(t.type,t)}answer(t){let e=this.waiting.get(t.id);this.waiting.delete(t.id),t.type==="done"?e?.resolve(t):e?e.reject(t):this.emit("error",t)}takeFrame(t){if(this.pendingFrame=Hf(t),!this.layout||Wa(t)!==this.layout.layout){this.acknowledge();return}let e=this.frame;this.frame=Lr(t,this.layout),this.frames++,this.emit("frame",this.frame),e&&Gf(e)}acknowledge(){this.resting=!this.resting,!(this.pendingFrame<0||this.resting)&&(this.source.used(this.pendingFrame),this.pendingFrame=-1)}};function f_(n){let t=atob(n.trim()),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e}async function p_(n){let t=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(t).arrayBuffer())}function m_({columns:n,low:t,step:e,order:i,planes:s},r,o){let a=r*n;if(o.length!==a*s)throw new Error("the recording is damaged");let l=new Int32Array(a);for(let c=0;c<n;c++){let h=0,d=0;for(let u=c*r;u<(c+1)*r;u++){let f=o[u];for(let v=1;v<s;v++)f|=o[v*a+u]<<8*v;let m=f>>>1^-(f&1);i===2?h+=d+=m:h+=m,l[u]=h}}return{columns:n,rows:r,low:t,step:e,whole:l}}function vr({columns:n,rows:t,low:e,step:i,whole:s},r,o){for(let a=0;a<n;a++)o[a]=e[a]+i[a]*s[a*t+r];return o}var aT=48,lT=250,cT=.1,hT=["play","pause","step","speed","seek","reset"];function __(){let n=document.getElementById("recording"),t=document.getElementById("recording-data");return!n||!t?null:new vf(JSON.parse(n.textContent??""),t.textContent??"")}var vf=class{constructor(t,e){this.base="",this.header=t,this.text=e,this.time=0,this.speed=1,this.playing=!0,this.number=0,this.shown=-1,this.layout=-1,this.last=0,this.lastStatus=0,this.parts=[],this.times=new Float64Array(0),this.events=null,this.jumped=()=>{}}async open(t){this.events=t;try{await this.load()}catch(i){t.state("damaged",`This page cannot be shown: ${i instanceof Error?i.message:i}.`);return}t.state("open",""),t.message(this.hello()),this.tellLayout(0),t.message({type:"parameters",parameters:[]}),t.message({type:"presets",presets:[]}),this.tellStatus(),this.last=performance.now();let e=i=>{this.tick(i),requestAnimationFrame(e)};requestAnimationFrame(e)}async load(){let t=f_(this.text);this.text="";let e=0,i=async(c,h)=>{let d=t.slice(e,e+=c.bytes);return m_(c,h,await p_(d))},{parts:s,times:r}=this.header,o=s.reduce((c,h)=>c+h.frames,0),a=await i(r,o);this.times=Float64Array.from(a.whole,c=>r.low[0]+r.step[0]*c);let l=0;for(let c of s){let h={};for(let f of c.streams)h[f.name]=await i(f,c.frames);let{layout:d,good:u}=c;this.parts.push({layout:d,first:l,frames:c.frames,good:u,numbers:h}),l+=c.frames}}hello(){let{ropewalk:t,title:e}=this.header;return{type:"hello",protocol:1,ropewalk:t,client:0,mode:"replay",can:hT,limits:{},title:e,folder:null,address:"",speeds:[.01,4],grabs:0,exports:[]}}send(t){let e=this.header.duration;switch(t.type){case"play":this.time>=e&&this.moveTo(0),this.playing=!0,this.last=performance.now();break;case"pause":this.playing=!1;break;case"step":this.playing=!1,this.time=this.times[Math.min(this.index+(t.count??1),this.times.length-1)];break;case"speed":this.speed=t.value;break;case"seek":this.moveTo(Math.min(Math.max(0,t.time),e));break;case"reset":this.moveTo(0);break}if(this.show(),this.tellStatus(),t.id===void 0)return;let{id:i,type:s}=t;queueMicrotask(()=>this.events?.message({type:"done",id:i,command:s,step:this.index,frame:this.number}))}used(){}moveTo(t){this.time=t,Math.abs(this.index-this.shown)>2&&this.jumped(this.index)}get index(){let[t,e]=[0,this.times.length];for(;e-t>1;){let i=t+e>>1;this.times[i]<=this.time+1e-6?t=i:e=i}return t}tick(t){let e=Math.min(.25,Math.max(0,(t-this.last)/1e3));this.last=t,this.playing&&(this.time=this.later(e*this.speed),this.playing=this.time<this.header.duration,(!this.playing||t-this.lastStatus>lT)&&this.tellStatus()),this.show()}later(t){let{duration:e,single:i}=this.header,{time:s}=this,r=this.times[this.times.length-1-i];if(!i||s+t<r)return Math.min(s+t,e);if(s<r)return r;let o=Math.min(1,(e-r)/(i*cT));return Math.min(s+t*o,e)}show(){let{index:t}=this;if(t===this.shown||!this.events)return;this.shown=t;let e=this.partOf(t);e!==this.layout&&this.tellLayout(e),this.number++,this.events.frame(this.frame(t))}partOf(t){return this.parts.findIndex(({first:e,frames:i})=>t<e+i)}tellLayout(t){this.layout=t,this.events?.message(this.parts[t].layout)}tellStatus(){this.lastStatus=performance.now();let{method:t,dt:e,duration:i}=this.header;this.events?.message({type:"status",playing:this.playing,speed:this.speed,realtime:this.playing?this.speed:0,slow:!1,text:"",time:this.time,step:this.index,dt:e,steps_per_frame:1,method:t,broken:!1,clients:1,address:"",duration:i})}frame(t){let{layout:e,first:i,good:s,numbers:r}=this.parts[this.partOf(t)],o=t-i,[a]=e.variants,{offsets:l,nodes:c,anchors:h}=a,d=new ArrayBuffer(e.bytes),u=new DataView(d,0,aT),f=(this.playing?1:0)|(t===this.times.length-1?16:0)|(o>=s?2:0);[1179670354,e.layout,this.number,f].forEach((N,I)=>u.setUint32(4*I,N,!0)),u.setFloat64(16,this.times[t],!0),u.setFloat64(24,t,!0),u.setFloat32(32,this.playing?this.speed:0,!0),u.setFloat32(36,this.speed,!0);let m=(N,I)=>new Float32Array(d,N,I),v=vr(r.scalars,o,m(l.scalars,e.scalars.length)),g=vr(r.positions,o,m(l.positions,3*c)),p=(N,I)=>{let V=e.scalars.indexOf(N);V>=0&&(v[V]=I)},y=vr(r.tension,o,new Float64Array(r.tension.columns)),[T,M]=g_(y,new Uint16Array(d,l.tension,c));p("tension_low",T),p("tension_high",M);let R=vr(r.speed,o,new Float64Array(c));p("speed_high",g_(R,new Uint16Array(d,l.speed,c))[1]);let A=vr(r.velocity,o,new Float32Array(3*h.length)),_=vr(r.force,o,new Float32Array(3*h.length)),E=m(l.anchors,10*h.length);h.forEach(({index:N},I)=>{E.set(g.subarray(3*N,3*N+3),10*I),E.set(A.subarray(3*I,3*I+3),10*I+3),E.set(_.subarray(3*I,3*I+3),10*I+6),E[10*I+9]=1});let k=m(l.grabs,Math.floor((e.bytes-l.grabs)/4));for(let N=0;N<k.length;N+=8)k[N]=-1;return d}};function g_(n,t){let[e,i]=[0,1e-30];for(let r of n)r<e&&(e=r),r>i&&(i=r);let s=65535/(i-e);for(let r=0;r<n.length;r++)t[r]=(n[r]-e)*s+.5;return[e,i]}var yf=[500,1e3,2e3],uT=1e3,dT=4503,$h=class{constructor(){this.base="./",this.socket=null,this.tries=0,this.ending="",this.events=null}open(t){this.events=t,this.connect()}connect(){let t=this.events,e=new URL("socket",location.href.split(/[?#]/)[0]);e.protocol=e.protocol.replace("http","ws");let i=new WebSocket(e,"ropewalk.1");i.binaryType="arraybuffer",this.socket=i,setTimeout(()=>{i.readyState===WebSocket.CONNECTING&&t.state("waiting","Setting up the simulation; its first run takes a minute or two …")},uT),i.onopen=()=>t.state("open",""),i.onmessage=({data:s})=>{if(typeof s!="string"){t.frame(s);return}let r=JSON.parse(s);r.type==="hello"&&([this.tries,this.ending]=[0,""]),r.type==="bye"&&(this.ending=r.text),t.message(r)},i.onclose=({code:s,reason:r})=>{if(this.socket!==i)return;let o=this.ending?yf[2]:yf[Math.min(this.tries++,yf.length-1)];(s===1e3||s===1001)&&(this.ending||="The server has ended."),s===dT?t.state("full",r||"As many pages as allowed are open."):this.ending?t.state("ended",this.ending):s===4400||s===4429||s===1009?t.state("lost",`The server closed the connection: ${r||s}.`):t.state("lost","The connection to the server is lost; the run goes on there."),setTimeout(()=>this.connect(),o)}}send(t){this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify(t))}used(t){this.send({type:"ack",frame:t})}};Ol(qm());var Mf=__(),x_=new Xh(Mf??new $h),fT=document.getElementById("app"),Sf=new Hl(fT,x_,d_);Mf?jm(Sf,Mf):Qm(Sf);Object.assign(window,{ropewalk:Km(Sf)});x_.open();})();
